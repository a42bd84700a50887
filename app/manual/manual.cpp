#include "app/manual/manual.h"

#include <sys/wait.h>

#include <array>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <utility>

#include "app/manual/parts.h"
#include "app/report/report.h"
#include "app/session/program_version.h"
#include "app/session/session.h"
#include "assets/assets.h"

namespace tact {

namespace {

constexpr auto kChapters = std::to_array<ManualChapter>({
    {"start", "Start here"},
    {"panes", "What each pane shows"},
    {"things", "The ten commonest things"},
    {"model", "What the model can and cannot say"},
    {"touch", "Actuators, to feel and to measure"},
    {"phones", "Phones in the room"},
    {"people", "Studies and training"},
    {"paper", "A study from question to paper"},
    {"teach", "Teaching"},
    {"formats", "Every format"},
    {"terminal", "In a terminal, in Python and R"},
    {"keys", "Keys, mouse and menus"},
    {"trouble", "When something is wrong"},
});

constexpr const char* kManualStyle = R"css(
html{scroll-behavior:smooth;scroll-padding-top:16px}
body{max-width:1160px}
main{display:grid;grid-template-columns:210px minmax(0,1fr);gap:28px;align-items:start}
nav{position:sticky;top:16px;font-size:13px;line-height:1.4}
nav ol{list-style:none;margin:20px 0 0;padding:0}
nav a{display:block;padding:5px 0;text-decoration:none}
nav a:hover{text-decoration:underline}
section{padding:26px 28px}
h2{font-size:21px}
h3{font-size:16px;margin:26px 0 6px}
h2+h3{margin-top:0}
ul,ol,dl{max-width:44em;margin:0 0 12px;padding-left:20px}
li{margin:0 0 5px}
dl{padding:0}
dt{font-weight:600;margin-top:10px}
dd{margin:0}
code,pre,kbd{font-family:"DejaVu Sans Mono",ui-monospace,monospace;font-size:12.5px}
pre{background:var(--field);border:1px solid var(--line);border-radius:6px;padding:10px 12px;
  overflow-x:auto;white-space:pre;line-height:1.45;margin:0 0 12px;overflow-wrap:normal}
.frame td{vertical-align:top;overflow-wrap:break-word}
td kbd,kbd{white-space:nowrap}
kbd{background:var(--field);border:1px solid var(--line);border-radius:4px;padding:1px 5px}
details{margin:0 0 6px;border-bottom:1px solid var(--line);padding:0 0 6px}
summary{cursor:pointer}
summary code{color:var(--accent)}
details pre{margin-top:8px}
.help{white-space:pre-wrap}
.menus{columns:2;column-gap:32px}
.menus h4{margin:14px 0 2px;break-after:avoid}
.file{margin:0 0 3px;color:var(--dim-text)}
code{white-space:nowrap}
.note{border-left:3px solid var(--warning);padding-left:12px}
figure{margin:14px 0 18px}
figcaption{margin-top:6px}
figure svg{border:1px solid var(--line);border-radius:6px}
@media (max-width:860px){
main{display:block}
code{white-space:normal}
nav{position:static}
nav ol{columns:2}
.menus{columns:1}
}
@media print{
main{display:block}
pre{white-space:pre-wrap}
section{break-inside:auto}
}
)css";

Expected<std::string> figure_of(const ManualSource& source, std::string_view rest) {
    const std::size_t bar = rest.find(" | ");
    if (bar == rest.npos) return Error{"expected {{picture NAME | what it shows}}"};
    const std::string name(rest.substr(0, bar));
    const std::string caption(rest.substr(bar + 3));
    const auto picture = source.picture(name);
    if (!picture) return picture.error();
    return html_of(HtmlFigure{.id = "picture-" + name,
                              .alt = caption,
                              .caption = html_escaped(caption),
                              .light = picture->light,
                              .dark = picture->dark});
}

Expected<std::string> part_of_manual(const ManualSource& source, KnownNumbers& numbers,
                                     std::string_view word, std::string_view rest) {
    if (word == "picture") return figure_of(source, rest);
    if (word == "number") return number_text(numbers, rest);
    if (word == "example") return example_html(rest);
    if (word == "effects") return effects_html();
    if (word == "table") return table_html(rest);
    if (word == "keys") return keys_html(source);
    if (word == "menus") return menus_html(source);
    if (word == "commands") return commands_html(source);
    if (word == "program") return html_escaped(source.program);
    return Error{
        "expected picture, number, example, effects, table, keys, menus, commands or "
        "program between {{ and }}, got \"" +
        std::string(word) + "\""};
}

std::string contents() {
    std::string html = "<nav class=\"screen\" aria-label=\"Contents\"><ol>\n";
    for (const ManualChapter& chapter : kChapters) {
        html += std::string("<li><a href=\"#") + chapter.id + "\">" +
                html_escaped(chapter.heading) + "</a></li>\n";
    }
    return html + "</ol></nav>\n";
}

}  // namespace

std::span<const ManualChapter> manual_chapters() { return kChapters; }

Expected<std::string> manual_page(const ManualSource& source) {
    KnownNumbers numbers;
    HtmlPage page;
    page.title = "The manual of " + source.program;
    page.lead =
        "Shape vibrations, watch what skin and nerves make of them, and see which ones people will "
        "tell apart, before you ask them.";
    page.body = contents() + "<div>\n";
    for (const ManualChapter& chapter : kChapters) {
        const std::string file = std::string("manual/") + chapter.id + ".html";
        const auto html =
            filled(asset(file), file, [&](std::string_view word, std::string_view rest) {
                return part_of_manual(source, numbers, word, rest);
            });
        if (!html) return html.error();
        page.body += html_section(chapter.id, chapter.heading, *html);
    }
    page.body += "</div>\n";
    page.foot = "<p>Made by " + html_escaped(source.program) +
                ": its pictures are drawn by the program, its numbers computed by the model.</p>\n";
    page.style = kManualStyle;
    return html_of(page);
}

namespace {

namespace fs = std::filesystem;

// In a process of its own: pictures are drawn as the window is, which one thread alone may do.
std::optional<ManualMade> made_manual(const ManualRequest& request, const std::stop_token& stop) {
    const auto folder = make_folder(request.page.parent_path());
    if (!folder) return ManualMade{request.page, folder.error().message};
    const auto process =
        started({request.program.string(), "manual", "--out", request.page.string()});
    if (!process) return ManualMade{request.page, process.error().message};
    const std::optional<int> status = ended(*process, stop);
    if (!status) return std::nullopt;
    if (*status == 0 && is_there(request.page)) return ManualMade{request.page, {}};
    return ManualMade{request.page, "\"tactspace manual --out " + request.page.string() +
                                        "\" in a terminal says why"};
}

// Not if the program was built again since.
bool is_current(const fs::path& page, const fs::path& program) {
    std::error_code none;
    const auto made = fs::last_write_time(page, none);
    if (none) return false;
    const auto built = fs::last_write_time(program, none);
    return !none && made >= built;
}

void forget_ended(ManualState& manual) {
    std::erase_if(manual.openers,
                  [](int process) { return waitpid(process, nullptr, WNOHANG) != 0; });
}

void show_in_browser(Ui& ui, ManualState& manual, const fs::path& page) {
    const auto process = started({"xdg-open", page.string()});
    if (!process) {
        return complain(ui, "No browser can be opened from here; the manual is " + page.string());
    }
    manual.openers.push_back(*process);
    say(ui, "The manual opens in the browser: " + page.string());
}

}  // namespace

fs::path installed_manual(const fs::path& program) {
    return program.parent_path().parent_path() / "share/doc/tactspace/manual.html";
}

fs::path kept_manual() {
    const std::string version(std::strrchr(kProgramVersion, ' ') + 1);
    const fs::path file = fs::path("tactspace") / ("manual-" + version + ".html");
    // Nothing changes the environment while the program runs.
    const char* cache = std::getenv("XDG_CACHE_HOME");  // NOLINT(concurrency-mt-unsafe)
    if (cache != nullptr && cache[0] == '/') return cache / file;
    const char* home = std::getenv("HOME");  // NOLINT(concurrency-mt-unsafe)
    if (home != nullptr && home[0] == '/') return fs::path(home) / ".cache" / file;
    return {};
}

void open_manual(Ui& ui, ManualState& manual) {
    const fs::path installed = installed_manual(manual.program);
    if (!manual.program.empty() && is_there(installed)) {
        return show_in_browser(ui, manual, installed);
    }
    const fs::path kept = kept_manual();
    if (manual.program.empty() || kept.empty()) {
        return complain(ui,
                        "There is no folder to make the manual in; \"tactspace manual --out "
                        "FILE.html\" in a terminal makes it.");
    }
    if (is_current(kept, manual.program)) return show_in_browser(ui, manual, kept);
    if (manual.job.busy()) return;
    manual.job.ask(
        {manual.program, kept},
        [](const ManualRequest& request, const std::stop_token& stop, std::atomic<float>&) {
            return made_manual(request, stop);
        },
        ui.wake, JobPolicy::finish);
    say(ui, "The manual is being made; it opens in a moment.");
}

void take_manual(Ui& ui, ManualState& manual) {
    if (!manual.openers.empty()) forget_ended(manual);
    const auto made = manual.job.latest();
    if (!made || made == manual.shown) return;
    manual.shown = made;
    if (!made->fault.empty()) return complain(ui, "The manual could not be made: " + made->fault);
    show_in_browser(ui, manual, made->page);
}

}  // namespace tact
