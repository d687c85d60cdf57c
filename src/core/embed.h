// Files that become part of the program.
#pragma once

/// Defines the global arrays name and nameEnd, once in a program: the bytes of a file, whose path is absolute,
/// and behind them a zero. The assembler reads the file. CMake lists it in the source's OBJECT_DEPENDS, and
/// compiles the source by itself.
#define CLEARWAY_EMBED(name, path)                                                                        \
    __asm__(".pushsection .rodata\n.balign 16\n.globl " #name ", " #name "End\n.hidden " #name ", " #name \
            "End\n" #name ":\n.incbin \"" path "\"\n" #name "End:\n.byte 0\n.popsection");                \
    extern "C" {                                                                                          \
    extern const char name[], name##End[];                                                                \
    }
