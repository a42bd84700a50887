#include "app/command_line/command_line.h"

#include <iostream>
#include <set>
#include <sstream>
#include <string_view>

#include "app/command_line/endings.h"
#include "app/command_line/options.h"
#include "model/common/expected.h"

namespace tact {

namespace {

// What a command throws for want of memory is a sentence like any other.
Expected<Done> outcome_of(const Chosen& chosen) {
    try {
        return chosen();
    } catch (...) {
        return thrown_error();
    }
}

}  // namespace

void add_commands(CLI::App& app, Commands& commands, Chosen& chosen) {
    add_predict_command(app, commands.predict, chosen);
    add_space_command(app, commands.space, chosen);
    add_stages_command(app, commands.stages, chosen);
    add_render_command(app, commands.render, chosen);
    add_export_command(app, commands.exported, chosen);
    add_devices_command(app, commands.devices, chosen);
    add_phones_command(app, commands.phones, chosen);
    add_play_command(app, commands.play, chosen);
    add_calibrate_command(app, commands.calibrate, chosen);
    add_subset_command(app, commands.subset, chosen);
    add_report_command(app, commands.report, chosen);
    add_groups_command(app, commands.groups, chosen);
    add_separate_command(app, commands.separate, chosen);
    add_steps_command(app, commands.steps, chosen);
    add_edit_command(app, commands.edit, chosen);
    add_compare_command(app, commands.compare, chosen);
    add_train_command(app, commands.train, chosen);
    add_findings_command(app, commands.findings, chosen);
    add_generate_command(app, commands.generate, chosen);
    add_paper_command(app, commands.paper, chosen);
    add_plan_command(app, commands.plan, chosen);
    add_study_command(app, commands.study, chosen);
    add_import_command(app, commands.import, chosen);
    add_measure_command(app, commands.measure, chosen);
    add_from_sound_command(app, commands.from_sound, chosen);
    add_library_command(app, commands.library, chosen);
    add_snapshot_command(app, commands.snapshot, chosen);
    add_lesson_command(app, commands.lesson, chosen);
    add_manual_command(app, commands.manual, chosen);
}

namespace {

// CLI11 lists what an option excludes by where it lies in memory, which is never the same twice.
std::string with_exclusions_in_order(std::string text) {
    constexpr std::string_view kExcludes = "Excludes: ";
    for (std::size_t at = text.find(kExcludes); at != text.npos; at = text.find(kExcludes, at)) {
        at += kExcludes.size();
        std::istringstream words(text.substr(at, text.find('\n', at) - at));
        std::set<std::string> names;
        std::size_t length = 0;
        for (std::string word; words >> word && word.starts_with("--");) {
            length += word.size() + 1;
            names.insert(word);
        }
        std::string in_order;
        for (const std::string& name : names) in_order += name + " ";
        if (length > 0) text.replace(at, length - 1, in_order, 0, length - 1);
    }
    return text;
}

// An Error without words was told by another process, or by this one before.
int told(const Error& fault, int exit_code) {
    if (!fault.message.empty()) std::cerr << "tactspace: " << fault.message << "\n";
    return exit_code;
}

// Help and version, or what is wrong with the usage.
int explained(const CLI::App& app, const CLI::ParseError& fault) {
    std::ostringstream words;
    const bool is_answer = app.exit(fault, std::cout, words) == 0;
    std::istringstream lines(words.str());
    for (std::string line; std::getline(lines, line);) std::cerr << line << "\n";
    if (!is_answer) return 2;
    const Expected<Done> printed = flushed_output();
    return printed ? 0 : told(printed.error(), 1);
}

}  // namespace

std::vector<CommandHelp> command_help() {
    CLI::App app;
    Commands commands;
    Chosen chosen;
    add_commands(app, commands, chosen);
    std::vector<CommandHelp> all;
    for (const CLI::App* sub : app.get_subcommands(std::function<bool(CLI::App*)>{})) {
        all.push_back({sub->get_name(), sub->get_description(),
                       with_exclusions_in_order(sub->help("tactspace"))});
    }
    return all;
}

int run_command_line(int argc, const char* const* argv, RunWindow run_window) {
    CLI::App app("Shape vibrations and see which ones people will tell apart.", "tactspace");
    app.set_version_flag("--version", TACT_VERSION);
    std::vector<std::filesystem::path> sets;
    app.add_option("SET", sets, std::string("opens the window on it: ") + kSetHelp);
    Commands commands;
    Chosen chosen = [&sets, run_window] { return run_window(sets); };
    add_commands(app, commands, chosen);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& fault) {
        return explained(app, fault);
    }
    Expected<Done> answer = outcome_of(chosen);
    if (answer) answer = flushed_output();
    const int interrupted = interrupted_exit_code();
    if (answer && interrupted != 0) {
        answer = Error{"stopped: what is written may not be all that was asked for"};
    }
    if (answer) return 0;
    return told(answer.error(), interrupted != 0 ? interrupted : 1);
}

}  // namespace tact
