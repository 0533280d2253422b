// Files of the source within a program: scripts and tables that it needs wherever it runs.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Puts the bytes of a file between NAME_begin and NAME_end, outside of all namespaces. The path counts from the folder
/// in which make runs. The Makefile names the file as a prerequisite of the object.
// The assembler copies the file, because a string literal would need escapes and could not be checked as what it is.
// Its names are global, though hidden, because on aarch64 local ones would share one address.
#define SOILWEAVE_EMBED(name, path)                                                                            \
  __asm__(".pushsection .rodata,\"a\"\n.globl " #name "_begin, " #name "_end\n.hidden " #name "_begin, " #name \
          "_end\n" #name "_begin:\n.incbin \"" path "\"\n" #name "_end:\n.popsection\n");                      \
  extern "C" const char name##_begin[], name##_end[];
