#include "tests/support/places.h"

namespace tact {

const char* const kGoldenDir = TACT_GOLDEN_DIR;
const char* const kAssetsDir = TACT_ASSETS_DIR;
const char* const kProgram = TACT_PROGRAM;

}  // namespace tact
