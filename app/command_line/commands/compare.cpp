// tactspace compare: metrics against what people said, as in the paper's Table 2.

#include <algorithm>
#include <iostream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <span>

#include "app/command_line/agreement/agreement.h"
#include "app/command_line/commands.h"
#include "app/command_line/output.h"
#include "app/command_line/rated_sets.h"
#include "model/io/people/agreement_json.h"
#include "model/text/json_fields.h"

namespace tact {

namespace {

nlohmann::json json_of(const SetAgreement& set, std::size_t m, Bookkeeping books) {
    nlohmann::json json = json_of(RatedTable{set.people, set.raters, set.table}, m, books);
    json["set"] = set.name;
    json["metric"] = key_of(set, m);
    json["left_out"] = json_of(set.left_out);
    const std::size_t own = set.table.metrics.size();
    if (m >= own) json["foreign"] = set.foreign[m - own].from;
    add_labels(json, set.labels);
    return json;
}

nlohmann::json json_of(const MeanAgreement& mean, const std::string& key, Bookkeeping books) {
    return {{"mean_of_sets", mean.sets},
            {"metric", key},
            {"rho", books == Bookkeeping::paper ? mean.absolute_rho : mean.signed_rho},
            {"rho_signed", mean.signed_rho},
            {"rho_absolute", mean.absolute_rho},
            {"K", mean.k},
            {"undefined_rho", mean.undefined_rho},
            {"failed_maps", mean.failed_maps}};
}

std::string json_text(const std::vector<SetAgreement>& sets, Bookkeeping books) {
    nlohmann::json all = nlohmann::json::array();
    const std::size_t metrics = metric_count(sets.front());
    for (const SetAgreement& set : sets) {
        for (std::size_t m = 0; m < metrics; ++m) all.push_back(json_of(set, m, books));
    }
    for (std::size_t m = 0; sets.size() > 1 && m < metrics; ++m) {
        all.push_back(json_of(mean_of(sets, m, books), key_of(sets.front(), m), books));
    }
    return text_of_json(all) + "\n";
}

std::string text_of(const CompareCommand& command, const std::vector<SetAgreement>& sets,
                    Bookkeeping books) {
    if (command.common.json) return json_text(sets, books);
    std::string text;
    for (const SetAgreement& set : sets) {
        text += (text.empty() ? "" : "\n") + agreement_text(set, command.paper_mode);
    }
    if (sets.size() > 1) text += means_text(sets, books);
    if (command.methods) text += methods_text(sets);
    return text;
}

// The tables asked for besides the answer.
struct CsvOut {
    const std::filesystem::path& file;
    void (*write)(std::ostream&, std::span<const SetAgreement>);
};
std::vector<CsvOut> tables_of(const CompareCommand& command) {
    std::vector<CsvOut> wanted;
    for (const CsvOut& table :
         {CsvOut{command.csv, write_metrics_csv}, CsvOut{command.people_csv, write_people_csv},
          CsvOut{command.differences_csv, write_differences_csv}}) {
        if (!table.file.empty()) wanted.push_back(table);
    }
    return wanted;
}

Expected<Done> can_write(const CompareCommand& command) {
    if (const auto writable = writable_result(command.out); !writable) return writable;
    for (const CsvOut& table : tables_of(command)) {
        if (const auto writable = writable_result(table.file); !writable) return writable;
    }
    return Done{};
}

}  // namespace

Expected<Done> run(const CompareCommand& command) {
    if (const auto writable = can_write(command); !writable) return writable;
    Expected<std::vector<ComparedSet>> compared = compared_sets(command);
    if (!compared) return compared.error();
    std::vector<SetAgreement> sets;
    for (ComparedSet& one : *compared) sets.push_back(std::move(one.agreement));
    const Bookkeeping books = command.paper_mode ? Bookkeeping::paper : Bookkeeping::plain;
    for (const CsvOut& table : tables_of(command)) {
        const auto written =
            write_result(table.file, [&](std::ostream& stream) { table.write(stream, sets); });
        if (!written) return written;
    }
    const std::string text = text_of(command, sets, books);
    return write_result(command.out, [&text](std::ostream& stream) { stream << text; });
}

}  // namespace tact
