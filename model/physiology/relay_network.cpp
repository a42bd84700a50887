#include "model/physiology/relay_network.h"

#include <algorithm>
#include <cassert>
#include <cstdlib>

namespace tact {

namespace {

std::size_t place(int half_width, int column, int row) {
    return static_cast<std::size_t>(row + half_width) *
               static_cast<std::size_t>(2 * half_width + 1) +
           static_cast<std::size_t>(column + half_width);
}

// A layer in a square of another half width: cut off, or surrounded by zeros.
RelayLayer framed(const RelayLayer& layer, int half_width) {
    RelayLayer result = empty_layer(half_width);
    const int shared = std::min(layer.half_width, half_width);
    for (int row = -shared; row <= shared; ++row) {
        std::copy_n(layer.cells.data() + place(layer.half_width, -shared, row), 2 * shared + 1,
                    result.cells.data() + place(half_width, -shared, row));
    }
    return result;
}

// Convolution with a cross (its own mirror image), clipped to 0..cap.
RelayLayer next_layer(const RelayLayer& input, const CrossKernel& kernel, double cap,
                      int half_width) {
    // A border around the output makes cells at its edge ordinary ones.
    const RelayLayer wide = framed(input, half_width + 1);
    const std::ptrdiff_t stride = 2 * half_width + 3;
    RelayLayer output = empty_layer(half_width);
    double* out = output.cells.data();
    for (int row = -half_width; row <= half_width; ++row) {
        const double* in = wide.cells.data() + place(half_width + 1, -half_width, row);
        for (int column = -half_width; column <= half_width; ++column, ++in, ++out) {
            const double arms = in[-1] + in[1] + in[-stride] + in[stride];
            const double sum = kernel.centre * in[0] + kernel.arm * arms;
            *out = std::clamp(sum, 0.0, cap);
        }
    }
    return output;
}

}  // namespace

double RelayLayer::at(int column, int row) const {
    if (std::abs(column) > half_width || std::abs(row) > half_width) return 0.0;
    return cells[place(half_width, column, row)];
}

double& RelayLayer::cell(int column, int row) {
    assert(std::abs(column) <= half_width && std::abs(row) <= half_width);
    return cells[place(half_width, column, row)];
}

RelayLayer empty_layer(int half_width) {
    const std::size_t side = 2 * static_cast<std::size_t>(half_width) + 1;
    return {half_width, std::vector<double>(side * side, 0.0)};
}

std::vector<RelayLayer> relay(const RelayLayer& spikes, const NeuralCodingParams& params,
                              bool cone_only) {
    const int count = params.excitatory_layers + params.inhibitory_layers;
    std::vector<RelayLayer> layers;
    layers.reserve(static_cast<std::size_t>(count));
    for (int k = 1; k <= count; ++k) {
        const bool excites = k <= params.excitatory_layers;
        int half_width = spikes.half_width + std::min(k, params.excitatory_layers);
        if (cone_only) half_width = std::min(half_width, count - k);
        layers.push_back(next_layer(layers.empty() ? spikes : layers.back(),
                                    excites ? params.excitatory : params.inhibitory,
                                    static_cast<double>(params.spike_cap), half_width));
    }
    return layers;
}

}  // namespace tact
