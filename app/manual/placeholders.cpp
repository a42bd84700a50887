#include "app/manual/placeholders.h"

#include <algorithm>

namespace tact {

Expected<std::string> filled(std::string_view text, std::string_view name, const PartOf& part_of) {
    std::string whole;
    std::size_t at = 0;
    for (;;) {
        const std::size_t open = text.find("{{", at);
        whole += text.substr(at, open - at);
        if (open == text.npos) return whole;
        const auto line = 1 + std::ranges::count(text.substr(0, open), '\n');
        const std::string place = std::string(name) + ":" + std::to_string(line) + ": ";
        const std::size_t close = text.find("}}", open);
        const std::string_view inner = text.substr(open + 2, close - open - 2);
        if (close == text.npos || inner.find('\n') != inner.npos) {
            return Error{place + "expected }} on the line of {{"};
        }
        const std::size_t blank = std::min(inner.find(' '), inner.size());
        const auto part =
            part_of(inner.substr(0, blank), inner.substr(std::min(blank + 1, inner.size())));
        if (!part) return Error{place + part.error().message};
        whole += *part;
        at = close + 2;
    }
}

}  // namespace tact
