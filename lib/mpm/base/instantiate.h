// The kinds of simulation: 2D and 3D, each in float and in double.
//
// Templates over the dimension and the real type are defined in .cpp files and instantiated there:
//
//     #define TIDEWATER_INSTANTIATE(D, Real) template void advance(Simulation<D, Real>&, double);
//     TIDEWATER_FOR_EACH_KIND(TIDEWATER_INSTANTIATE)
#pragma once

#define TIDEWATER_FOR_EACH_KIND(INSTANTIATE) \
    INSTANTIATE(2, float)                    \
    INSTANTIATE(2, double)                   \
    INSTANTIATE(3, float)                    \
    INSTANTIATE(3, double)

// The same for templates over the dimension alone.
#define TIDEWATER_FOR_EACH_DIMENSION(INSTANTIATE) \
    INSTANTIATE(2)                                \
    INSTANTIATE(3)
