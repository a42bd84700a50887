// How soon a change of a loop is heard, and that it is no click: the word "changes" of capture.
#pragma once

#include <string>
#include <vector>

int heard_changes(const std::vector<std::string>& words);
