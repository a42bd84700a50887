// tactspace generate: candidate sets from levels and ranges of parameters.

#include <iostream>
#include <nlohmann/json.hpp>

#include "app/command_line/commands.h"
#include "app/command_line/output.h"
#include "app/map/map.h"
#include "app/progress/progress.h"
#include "model/design_space/candidates.h"
#include "model/io/set/set_file.h"
#include "model/io/set/spec_file.h"
#include "model/set/set_candidates.h"
#include "model/text/json_fields.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

struct Made {
    Candidates found;
    std::size_t fresh = 0;  // of those kept, not in the set already
    PatternSet set;
};

Expected<Made> make(const PatternSet& set) {
    const auto found = candidates(*set.generator, set.model.coding.tables);
    if (!found) return found.error();
    const std::vector<Candidate> fresh = new_to(set, found->kept, Before::replaced);
    auto with = with_candidates(set, *set.generator, fresh, Before::replaced);
    if (!with) return with.error();
    return Made{*found, fresh.size(), std::move(*with)};
}

std::string text_of(const Made& made) {
    const Candidates& found = made.found;
    const auto line = [](std::size_t count, const char* what) {
        return count == 0 ? "" : grouped_digits(count) + " " + what + "\n";
    };
    std::string text = line(found.combinations, "combinations");
    text += line(found.doubles, "doubles of others among them");
    text += line(found.rejected.band, "rejected: outside the device's band");
    text += line(found.rejected.displacement, "rejected: too much displacement");
    text += line(found.rejected.detectability, "rejected: not detectable enough");
    text += line(found.kept.size() - made.fresh, "in the set already");
    return text + grouped_digits(made.fresh) + " patterns\n";
}

nlohmann::json json_of(const Made& made) {
    const Rejections& rejected = made.found.rejected;
    return {{"combinations", made.found.combinations},
            {"doubles", made.found.doubles},
            {"rejected",
             {{"band", rejected.band},
              {"displacement", rejected.displacement},
              {"detectability", rejected.detectability}}},
            {"in_the_set_already", made.found.kept.size() - made.fresh},
            {"patterns", made.fresh},
            {"patterns_of_the_set", made.set.vibrations.size()},
            {"estimated_map_s", expected_map_s(made.set)}};
}

}  // namespace

Expected<Done> run(const GenerateCommand& command) {
    const Expected<Loaded> loaded = read_spec_file(command.spec);
    if (!loaded) return loaded.error();
    for (const std::string& remark : loaded->remarks) std::cerr << "tactspace: " << remark << "\n";
    const Expected<Made> made = make(loaded->set);
    if (!made) return Error{command.spec.string() + ": " + made.error().message};
    if (!command.count) {
        const Expected<Done> written = write_set_file(command.out, made->set);
        if (!written) return written;
        std::cerr << "tactspace: wrote " << grouped_digits(made->set.vibrations.size())
                  << " patterns to " << command.out.string() << "; a map of them takes "
                  << estimate_text(expected_map_s(made->set)) << "\n";
    }
    return write_result({}, [&](std::ostream& stream) {
        stream << (command.json ? text_of_json(json_of(*made)) + "\n" : text_of(*made));
    });
}

}  // namespace tact
