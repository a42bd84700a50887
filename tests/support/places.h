// Where the tests find golden tables, assets and the program. Apart from the tests themselves: of
// all their sources only one depends on where the checkout lies.
#pragma once

namespace tact {

extern const char* const kGoldenDir;
extern const char* const kAssetsDir;
extern const char* const kProgram;

}  // namespace tact
