"""A command of the package with the interface of the C++ tools: a table of options, help, manual page, completion, exit statuses."""
# SPDX-License-Identifier: GPL-3.0-or-later
import contextlib
import dataclasses
import os
import sys
import textwrap

from .errors import suggestion

VERSION = "0.1.0"
LICENCE = "Licence GPL-3.0-or-later: free software, to change and to pass on; there is no warranty."
STATUSES = {0: "done", 64: "wrong usage", 65: "bad input data", 66: "input missing", 69: "a program or package is missing",
            73: "cannot create the output", 74: "reading or writing failed"}


class Failure(Exception):
    """The failure that ends a command: its exit status, and one line for each mistake."""

    def __init__(self, status, *lines):
        super().__init__("\n".join(lines))
        self.status, self.lines = status, lines


@dataclasses.dataclass(frozen=True)
class Option:
    """An option: its names, the word for its value ("" for a flag), what it does, whether it may be given again."""

    names: tuple
    value: str
    sentence: str
    repeated: bool = False


GENERAL = (Option(("--force",), "", "overwrite an existing output file"), Option(("-q", "--quiet"), "", "no notes on standard error"),
           Option(("-h", "--help"), "", "this text"), Option(("--version",), "", "name, version and licence"),
           Option(("--man",), "", "manual page (pipe it into 'man -l -')"), Option(("--completion",), "", "completion script for bash"))


@dataclasses.dataclass(frozen=True)
class Command:
    """A command and its texts. words: explanations of the first operand's choices, by name."""

    name: str
    sentence: str
    usage: str
    description: str
    words: dict
    options: tuple
    examples: tuple

    def all_options(self):
        """Returns the options of this command, then the options of all commands."""
        return (*self.options, *GENERAL)

    def parse(self, arguments):
        """Returns options by long name and the operands. Raises Failure, 64, for unknown options and values."""
        given, operands, wrong = {o.names[-1]: [] for o in self.all_options()}, [], []
        known = {name: o for o in self.all_options() for name in o.names}
        words = iter(arguments)
        for word in words:
            if word == "--":
                operands += words
            elif not word.startswith("-") or word == "-":
                operands.append(word)
            else:
                name, equals, value = word.partition("=")
                option = known.get(name)
                if option is None:
                    near = suggestion(name, [n for n in known if n.startswith("--")])
                    wrong.append(f"unknown option '{name}'" + (near if "mean" in near else ""))
                    continue
                if option.value and not equals:
                    value = next(words, None)
                if option.value and not value:
                    wrong.append(f"{name} needs {option.value}")
                elif not option.value and equals:
                    wrong.append(f"{name} takes no value")
                elif given[option.names[-1]] and not option.repeated and option.value:
                    wrong.append(f"{name} is given twice")
                else:
                    given[option.names[-1]].append(value or True)
        if wrong:
            raise Failure(64, *wrong)
        return given, operands

    def about(self, given):
        """Returns the text for --help, --version, --man or --completion; None without such an option."""
        for name, text in (("--help", self.help), ("--version", self.version), ("--man", self.man), ("--completion", self.completion)):
            if given[name]:
                return text()
        return None

    def version(self):
        """Returns name, version and licence."""
        return f"{self.name} (soilweave) {VERSION}\n{LICENCE}\n"

    def help(self):
        """Returns a summary on one screen: 40 lines of at most 100 columns."""
        rows = [(", ".join(o.names) + (f" {o.value}" if o.value else ""), o.sentence) for o in self.all_options()]
        wide = max(len(left) for left, _ in rows) + 4
        lines = [f"{self.name}: {self.sentence}", f"Usage: {self.usage}", "Examples:"]
        for command, sentence in self.examples:
            lines += [f"  {command}", f"      {sentence}"]
        lines += ["Kinds:", *(f"  {name:<{wide - 2}}{words}" for name, words in self.words.items()), "Options:"]
        lines += [f"  {left:<{wide - 2}}{right}" for left, right in rows]
        lines += textwrap.wrap("Exit status: " + ", ".join(f"{k} {v}" for k, v in STATUSES.items()), 98)
        return "\n".join(lines) + "\n"

    def man(self):
        """Returns the manual page as roff source."""
        def roff(text):
            text = text.replace("\\", "\\e").replace("-", "\\-")
            return f"\\&{text}" if text.startswith((".", "'")) else text
        lines = [f'.TH {roff(self.name)} 1 "" "soilweave {VERSION}" "Soilweave"', ".SH NAME", f"{self.name} \\- {roff(self.sentence)}",
                 ".SH SYNOPSIS", roff(self.usage), ".SH DESCRIPTION", roff(self.description)]
        for name, words in self.words.items():
            lines += [".TP", f"\\fB{roff(name)}\\fR", roff(words)]
        lines.append(".SH OPTIONS")
        for option in self.all_options():
            names = ", ".join(f"\\fB{roff(name)}\\fR" for name in option.names)
            lines += [".TP", names + (f" \\fI{roff(option.value)}\\fR" if option.value else ""), roff(option.sentence)]
        lines.append(".SH EXAMPLES")
        for command, sentence in self.examples:
            lines += [".PP", roff(sentence), ".PP", ".RS", ".EX", roff(command), ".EE", ".RE"]
        lines.append(".SH EXIT STATUS")
        for status, meaning in STATUSES.items():
            lines += [".TP", str(status), roff(meaning)]
        return "\n".join(lines) + "\n"

    def completion(self):
        """Returns a completion script for bash: kinds first, then files, and options after a dash."""
        options = " ".join(name for o in self.all_options() for name in o.names)
        return f"""# bash completion for {self.name}
_{self.name}() {{
  local current="${{COMP_WORDS[COMP_CWORD]}}"
  if [[ $current == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "{options}" -- "$current")
  elif [[ $COMP_CWORD -eq 1 ]]; then
    mapfile -t COMPREPLY < <(compgen -W "{' '.join(self.words)}" -- "$current")
  else
    mapfile -t COMPREPLY < <(compgen -f -- "$current")
  fi
}}
complete -o filenames -F _{self.name} {self.name}
"""

    def run(self, act, arguments):
        """Calls act(options, operands) and returns the exit status. Error messages begin with the command's name."""
        try:
            given, operands = self.parse(arguments)
            text = self.about(given)
            if text is None:
                act(given, operands)
            else:
                put_out(text)
        except Failure as failure:
            for line in failure.lines:
                say(f"{self.name}: {line}")
            return failure.status
        return 0


def say(line):
    """Writes a line to standard error with control characters escaped. A line that cannot be written is no error."""
    shown = "".join(c if c.isprintable() else c.encode("unicode_escape", "surrogatepass").decode() for c in line)
    with contextlib.suppress(OSError):
        print(shown, file=sys.stderr, flush=True)


def put_out(text):
    """Writes text or bytes to standard output. A closed pipe is no error; a full disk is one."""
    try:
        sys.stdout.flush()
        sys.stdout.buffer.write(text if isinstance(text, bytes) else text.encode())
        sys.stdout.buffer.flush()
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    except OSError as error:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        raise Failure(74, f"standard output: {error.strerror}; not everything was written") from error
