// What a table of kernels and its instruction set are called. Only macros: the files that are built once per
// instruction set include it.
#pragma once

#define RIGSOUND_QUOTED(x) #x
#define RIGSOUND_QUOTE(x) RIGSOUND_QUOTED(x)
#define RIGSOUND_JOINED(a, b) a##b
#define RIGSOUND_JOIN(a, b) RIGSOUND_JOINED(a, b)

/// RIGSOUND_ISA as text, and `name` with it behind.
#define RIGSOUND_ISA_NAME RIGSOUND_QUOTE(RIGSOUND_ISA)
#define RIGSOUND_OF_ISA(name) RIGSOUND_JOIN(name, RIGSOUND_ISA)
