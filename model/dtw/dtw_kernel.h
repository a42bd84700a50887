// The inner loops of dtw.h, one file per instruction set, and which of them this processor runs.
//
// Exact     all of them give the bits of the textbook loop.
// Left out  single precision; NaN, which no minimum here would order.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

namespace tact {

// Some consecutive rows of D[i, j], for several pairs of signals side by side: where an array has
// one value per row or column, it has them [row or column][pair].
//
// Row r is at column t - r at step t. So with R rows, b and row are read, and row is written, up to
// R - 1 columns before the first and after the last; there b may be anything finite. A strip can be
// left after any step and taken up again from its state.
struct DtwStrip {
    const double* a = nullptr;  // of the rows
    const double* b = nullptr;  // of the column of row 0 in the first of the steps, and backwards
                                // from there: of the next column at b[-1]
    double* row = nullptr;  // D of the row above, from that column on; becomes D of the last row
    std::size_t steps = 0;
    double* reached = nullptr;     // D of each row where the last step left it
    double* above_left = nullptr;  // D of the row above each, one column before the next step's
    double waiting_cost = 0.0;     // above 0: for along_at_cost alone
};

struct DtwSweep {
    std::size_t pairs;                      // side by side
    std::size_t rows;                       // of a strip
    void (*along)(DtwStrip strip);          // waiting is free
    void (*along_at_cost)(DtwStrip strip);  // one sum more in a cell
};

struct DtwKernel {
    const char* name;     // as TACTSPACE_SIMD has it
    DtwSweep many_pairs;  // one in every lane of a register
    DtwSweep one_pair;    // several rows in a register: slower per cell, sooner there
};

// Those this processor can run, the fastest first.
std::span<const DtwKernel> dtw_kernels();

// The kernel of that name; default: the fastest.
const DtwKernel& dtw_kernel(std::string_view name);

// The kernel in use, named by the environment variable TACTSPACE_SIMD (avx512, avx2 or baseline);
// default: the fastest. The variable is read once; an unknown name is ignored.
const DtwKernel& dtw_kernel();

}  // namespace tact
