// The C interface of PhySim: C99, and C++. The guide is docs/c.md; settings are in docs/settings.md.
//
// Handles. Everything is made by a call that writes a handle, and given back by physim_free(). A handle is no address:
// one that is null, freed, or of another kind is refused by every call, and never followed.
//
// Errors. A call returns PHYSIM_OK or what went wrong. The texts of the last error of the calling thread stay until its
// next error. No exception leaves a call, and nothing ends the program. After an error outputs are as they were.
//
// Structs and columns. A struct that a call takes by itself begins with `size`, which the caller sets to the sizeof
// that the caller was compiled with; members behind it count as zero, and zero is always the default. Arrays of structs
// come with that size as `each`. Columns are the caller's memory, one number for each row; null: not wanted, or as
// defined.
//
// Threads. A handle that is only read may be used by any number of threads at once: flying and reading a physim_def,
// asking flights, scenes, figures, and a world between its steps. A call whose handle is not const changes what it
// names, and is the only one that uses it meanwhile. Callbacks of wind and force fields come from any thread; all
// others from the thread that steps. In a callback the world may be read and not changed.
//
// Units are SI; angles are in radians. The world frame has x downrange, y up, z to the right. Vectors are three
// doubles. The same calls give the same bits as in C++, on every machine.
#ifndef PHYSIM_H
#define PHYSIM_H

#include "physim/c_flights.h"
#include "physim/c_worlds.h"

#endif
