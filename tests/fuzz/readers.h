// Every reader of what others wrote, as a fuzzer calls it: bytes in, and a law that must hold.
//
// What is accepted and can be written again reads back as the same; what a set may hold can be
// saved. A broken law aborts with a word, which a fuzzer takes for a crash.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tact::fuzz {

struct Reader {
    const char* name;
    bool (*read)(std::string_view bytes);  // whether it was accepted
    std::vector<std::string> (*seeds)();   // small inputs; one of them is accepted
    std::vector<std::string> words;        // of its grammar, for the dictionary
};

std::span<const Reader> text_readers();    // from memory
std::span<const Reader> file_readers();    // which open a path
std::span<const Reader> device_readers();  // of what a device says
std::span<const Reader> export_readers();  // of what writers make of any pattern

std::vector<Reader> all_readers();

[[noreturn]] void broken(const char* word);

// Aborts with the word where the law does not hold: a condition, or a value that may be missing.
template <class Law>
void hold(const Law& law, const char* word) {
    if (!law) broken(word);
}

// For readers of what is not written again: whether it was accepted.
template <class Result>
bool is_read(const Result& result) {
    if (!result) hold(!result.error().message.empty(), "a refusal says why");
    return static_cast<bool>(result);
}

}  // namespace tact::fuzz
