"""Numbers as text in sentences."""
# SPDX-License-Identifier: GPL-3.0-or-later
import re

# A no-break space keeps a number and its unit on one line.
_SPACE = "\u00a0"


def spell(value, digits=3):
    """Returns a finite number to so many significant digits, without an exponent from 1e-4 to 1e7: 1730, 4.54, −0.0121."""
    if value == 0:
        return "0"
    # Rounding may reach the next power of ten.
    power = int(f"{value:.{digits - 1}e}".split("e")[1])
    if not -5 < power < 7:
        mantissa, exponent = f"{value:.{digits - 1}e}".split("e")
        return f"{mantissa}e{int(exponent):+d}".replace("-", "−")
    decimals = digits - 1 - power
    return f"{round(value, decimals):.{max(decimals, 0)}f}".replace("-", "−")


def quantity(text, unit):
    """Returns a number that is spelt already with its unit; pure numbers have none."""
    return text if unit == "1" else f"{text}{_SPACE}°" if unit == "deg" else f"{text}{_SPACE}{unit}"


def plain(text):
    """Returns text with its numbers as readers know them: 6.897e+04 as 68970, and with minus signs."""
    def spelt(match):
        value = float(match[0])
        return spell(value, len(match[1].replace(".", ""))) if 1e-5 <= abs(value) < 1e7 else match[0].replace("-", "−")
    text = re.sub(r"(?<![\w.])(\d(?:\.\d+)?)e[-+]\d+", spelt, text)
    return re.sub(r"(?<!\w)-(?=\d)", "−", text)
