#include "model/io/recordings/memory_sound.h"

#include <algorithm>
#include <cstdio>
#include <cstring>

namespace tact {

namespace {

MemorySound& of(void* user) { return *static_cast<MemorySound*>(user); }

sf_count_t length(void* user) { return static_cast<sf_count_t>(of(user).bytes.size()); }

sf_count_t tell(void* user) { return static_cast<sf_count_t>(of(user).position); }

sf_count_t seek(sf_count_t offset, int whence, void* user) {
    if (whence == SEEK_CUR) offset += tell(user);
    if (whence == SEEK_END) offset += length(user);
    of(user).position = static_cast<std::size_t>(std::max<sf_count_t>(offset, 0));
    return tell(user);
}

sf_count_t read(void* target, sf_count_t count, void* user) {
    MemorySound& memory = of(user);
    const std::size_t left = memory.bytes.size() - std::min(memory.position, memory.bytes.size());
    const std::size_t taken = std::min(left, static_cast<std::size_t>(count));
    std::memcpy(target, memory.bytes.data() + memory.position, taken);
    memory.position += taken;
    return static_cast<sf_count_t>(taken);
}

sf_count_t write(const void* source, sf_count_t count, void* user) {
    MemorySound& memory = of(user);
    const auto size = static_cast<std::size_t>(count);
    memory.bytes.resize(std::max(memory.bytes.size(), memory.position + size), '\0');
    std::memcpy(memory.bytes.data() + memory.position, source, size);
    memory.position += size;
    return count;
}

SNDFILE* opened_in(MemorySound& memory, int mode, SF_INFO& info) {
    static SF_VIRTUAL_IO calls{length, seek, read, write, tell};
    return sf_open_virtual(&calls, mode, &info, &memory);
}

}  // namespace

SNDFILE* open_for_reading(MemorySound& memory, SF_INFO& info) {
    return opened_in(memory, SFM_READ, info);
}

SNDFILE* open_for_writing(MemorySound& memory, SF_INFO& info) {
    return opened_in(memory, SFM_WRITE, info);
}

}  // namespace tact
