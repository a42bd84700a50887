// A field for a number that is described: its words, slider, range and steps are those of
// everything that takes the number.
#pragma once

#include <cmath>
#include <type_traits>

#include "app/ui/widgets.h"
#include "model/text/described.h"

namespace tact {

// `id` is its name for tests. Shown are number.times as many as files hold.
constexpr Field field_of(const Number& number, const char* id) {
    return {.id = id,
            .label = number.label,
            .format = number.format,
            .slider = number.shown(number.slider),
            .typed = number.shown(number.range),
            .step = number.step,
            .snap = number.snap,
            .logarithmic = number.logarithmic,
            .help = number.help};
}

// The same with where the number is: in shown units.
template <class Struct>
struct DescribedField {
    Field field;
    double (*get)(const Struct&);
    void (*set)(Struct&, double);
};

// `path`: members from the struct down to the number.
template <const Number& number, class Struct, auto... path>
constexpr DescribedField<Struct> described_field(const char* id) {
    return {field_of(number, id),
            [](const Struct& all) { return number.times * static_cast<double>((all.*....*path)); },
            [](Struct& all, double shown) {
                auto& value = (all.*....*path);
                if constexpr (std::is_same_v<decltype(value), int&>) {
                    value = static_cast<int>(std::lround(shown / number.times));
                } else {
                    value = shown / number.times;
                }
            }};
}

}  // namespace tact
