// Runs the benchmarks and ends with a table of what they owe.
#include <benchmark/benchmark.h>

#include <cstdio>
#include <string>
#include <vector>

namespace {

// Why a benchmark was given up, or its label. The names of the former changed with 1.8.
template <class Run>
const std::string& words_of(const Run& run) {
    if constexpr (requires { run.skip_message; }) {
        return run.skipped ? run.skip_message : run.report_label;
    } else {
        return run.error_occurred ? run.error_message : run.report_label;
    }
}

class TableReporter : public benchmark::ConsoleReporter {
  public:
    TableReporter() : ConsoleReporter(OO_None) {}

    void ReportRuns(const std::vector<Run>& runs) override {
        ConsoleReporter::ReportRuns(runs);
        for (const Run& run : runs) {
            const std::string& words = words_of(run);
            if (words.empty()) continue;
            lines_.push_back({run.run_name.function_name, words});
        }
    }

    void Finalize() override {
        std::puts("");
        for (const Line& line : lines_) {
            std::printf("%-36s  %s\n", line.name.c_str(), line.words.c_str());
        }
    }

  private:
    struct Line {
        std::string name;
        std::string words;
    };
    std::vector<Line> lines_;
};

}  // namespace

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
    TableReporter reporter;
    benchmark::RunSpecifiedBenchmarks(&reporter);
}
