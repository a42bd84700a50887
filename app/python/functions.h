// The functions of the module that take what people said, patterns and files, or write them
// (help.h).
//
// Output    errors are those of app/python/scalars.h
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

namespace tact {

pybind11::dict compare(const pybind11::object& matrix, const pybind11::object& ratings,
                       const pybind11::object& metric, const pybind11::object& threads,
                       const pybind11::object& given, const pybind11::object& progress);

pybind11::dict paper(const pybind11::object& given, const pybind11::object& threads,
                     const pybind11::object& progress);

pybind11::dict plan_study(const pybind11::object& matrix, const pybind11::object& rival,
                          const pybind11::object& people, const pybind11::object& rho,
                          const pybind11::object& reliability, const pybind11::object& pilot,
                          const pybind11::object& pairs, const pybind11::object& studies,
                          const pybind11::object& seed, const pybind11::object& threads,
                          const pybind11::object& progress);

pybind11::dict train_sets(const pybind11::object& given, const pybind11::object& objective,
                          const pybind11::object& step, const pybind11::object& leave_out,
                          const pybind11::object& rate_hz, const pybind11::object& threads,
                          pybind11::object model, const pybind11::object& progress);

pybind11::array render_pattern(const pybind11::object& pattern, const pybind11::object& rate_hz);

pybind11::object edit_pattern(const pybind11::object& pattern, const pybind11::object& edits,
                              const pybind11::object& model);

pybind11::dict separate(const pybind11::object& given, const pybind11::object& pair,
                        const pybind11::object& change, const pybind11::object& among,
                        const pybind11::object& closest, const pybind11::object& threshold,
                        const pybind11::object& threads, const pybind11::object& progress);

pybind11::dict report(const pybind11::object& given, const pybind11::object& count,
                      const pybind11::object& closer_than, const pybind11::object& include_unfelt,
                      const pybind11::object& threads, const pybind11::object& time_limit_s,
                      const pybind11::object& progress);

pybind11::dict steps(const pybind11::object& given, const pybind11::object& start,
                     const pybind11::object& end, const pybind11::object& count,
                     const pybind11::object& parameter, const pybind11::object& metric,
                     const pybind11::object& threads, const pybind11::object& progress);

pybind11::dict groups(const pybind11::object& given, const pybind11::object& count,
                      const pybind11::object& cut, const pybind11::object& threads,
                      const pybind11::object& progress);

pybind11::dict export_set(const pybind11::object& given, const pybind11::object& folder,
                          const pybind11::object& format, const pybind11::object& patterns,
                          const pybind11::object& onto, const pybind11::object& rate_hz,
                          const pybind11::object& bits, const pybind11::object& count,
                          const pybind11::object& loss, const pybind11::object& overwrite,
                          const pybind11::object& threads, const pybind11::object& progress);

pybind11::dict read_set(const pybind11::object& path, const pybind11::object& actuator,
                        const pybind11::object& progress);

void write_set(const pybind11::object& path, const pybind11::object& set);

pybind11::dict read_ratings_file(const pybind11::object& path, const pybind11::object& names,
                                 const pybind11::object& scale);

}  // namespace tact
