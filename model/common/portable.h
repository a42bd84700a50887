// Elementary functions that give the same bits on every processor.
//
// The C library picks its own by what the processor has: with FMA and without, the last bit of a
// sine differs now and then. What decides a number of this program is computed by these instead.
// They are made of the four operations and the square root, which IEEE 754 defines to the bit.
//
// Output    what std:: gives, the special cases too; within 0.505 units in the last place, so that
// all
//           but one result in two thousand are the nearest double; erfc within 12 units
// Valid     sin, cos, tan: angles up to 2^48, beyond which a double has few digits of a turn left;
//           sqrt: numbers of 1e-300 to 1e300
// Left out  errno, floating-point flags, rounding modes but to nearest.
// Exact     same argument, same bits, on any instruction set.
#pragma once

#include <complex>

namespace tact::portable {

double sin(double angle_rad);
double cos(double angle_rad);
double tan(double angle_rad);
double atan(double value);
double exp(double value);
double log(double value);
double log2(double value);
double log10(double value);
double pow(double base, double exponent);
double hypot(double a, double b);
double erfc(double value);

// std::abs, std::polar and std::sqrt of complex numbers.
double abs(std::complex<double> value);
std::complex<double> polar(double length, double angle_rad);
std::complex<double> sqrt(std::complex<double> value);

}  // namespace tact::portable
