// The functions of the module that take what people said, and those that read files (help.h).
//
// Output    errors are thrown as ValueError
#pragma once

#include <pybind11/pybind11.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tact {

pybind11::dict compare(const pybind11::object& matrix, const pybind11::object& ratings,
                       const std::string& metric, int threads);

pybind11::dict plan_study(const pybind11::object& matrix, const pybind11::object& rival,
                          const std::vector<int>& people, const std::optional<double>& rho,
                          const std::optional<double>& reliability, const pybind11::object& pilot,
                          int pairs, int studies, int seed, int threads);

pybind11::dict train_sets(const std::vector<pybind11::dict>& given, const std::string& objective,
                          double step, const std::string& leave_out, double rate_hz, int threads,
                          pybind11::object model);

pybind11::dict read_set(const std::filesystem::path& path);

pybind11::dict read_ratings_file(const std::filesystem::path& path,
                                 const std::optional<std::vector<std::string>>& names,
                                 const std::string& scale);

}  // namespace tact
