// Files of the source within a program: scripts and tables that it needs wherever it runs.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Puts a file's bytes between NAME_begin and NAME_end, outside of all namespaces.
/// The path counts from the folder in which make runs.
/// The Makefile must name the file as a prerequisite of the object.
// The assembler copies the file, since a string literal would need escapes.
// The names are global but hidden: local ones share one address on aarch64.
#define SOILWEAVE_EMBED(name, path)                                                                            \
  __asm__(".pushsection .rodata,\"a\"\n.globl " #name "_begin, " #name "_end\n.hidden " #name "_begin, " #name \
          "_end\n" #name "_begin:\n.incbin \"" path "\"\n" #name "_end:\n.popsection\n");                      \
  extern "C" const char name##_begin[], name##_end[];
