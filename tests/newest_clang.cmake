# The newest clang there is, for the presets of sanitizers and fuzzers (CMakePresets.json): its code with
# address and undefined is compiled in half the time of g++. app/packages installs the newest of the
# distribution; 16 is the first that knows C++20.
file(GLOB clangs /usr/bin/clang++-[1-9]*)
list(FILTER clangs INCLUDE REGEX "clang\\+\\+-(1[6-9]|[2-9][0-9])$")
if(NOT clangs)
    message(FATAL_ERROR "expected a clang that knows C++20, 16 or newer, in /usr/bin")
endif()
list(SORT clangs COMPARE NATURAL ORDER DESCENDING)
list(GET clangs 0 CMAKE_CXX_COMPILER)
