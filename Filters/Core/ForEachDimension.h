// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_ForEachDimension_h
#define hashedoctree_ForEachDimension_h

/** Applies a macro to each dimension that the core is compiled for. */
#define HASHEDOCTREE_FOR_EACH_DIMENSION(Macro) Macro(1) Macro(2) Macro(3) Macro(4)

#endif
