// The law that no key of a file of ours is passed over because of a slip: two letters of each key
// are exchanged in turn, and the reader has to name the wrong one and the right one.
#pragma once

#include <functional>
#include <set>
#include <string>

namespace tact {

// `fault_of` reads a document and answers what is wrong with it, or nothing. Objects whose keys are
// anybody's names are given by their places. Keys of fewer than four letters are left out: any two
// are alike.
void check_misspelt_keys_refused(const std::string& document,
                                 const std::function<std::string(const std::string&)>& fault_of,
                                 const std::set<std::string>& of_names = {});

}  // namespace tact
