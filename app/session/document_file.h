// The document's file, which others may write as well: what it held when it was last read or
// written here, and which of a person's windows have it open.
//
// Left out  windows of other people and on other machines: what they write is noticed all the same
//           before it is written over.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "app/session/session.h"

namespace tact {

// Mark of the bytes of a file, to notice that they changed; empty: it cannot be read.
std::optional<std::uint64_t> content_mark(const std::filesystem::path& file);

// Takes the file for this window, and gives back the one taken before. False: another window has
// it. Without a state folder nobody knows.
bool hold_document(Session& session, const std::filesystem::path& file);
void release_document(Session& session);

}  // namespace tact
