// Whether kernels have copies of their loops for the rungs that are flown most.
#pragma once

/// 0: these kernels know no rungs. They are those that a better copy replaces; all other paths give the same bits.
#ifndef PHYSIM_KNOWS_RUNGS
#define PHYSIM_KNOWS_RUNGS 1
#endif
