#include "devices/device/actuator_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cctype>
#include <cerrno>
#include <cstdlib>

#include "model/common/fingerprint.h"

namespace tact {

namespace {

// A folder of this user, gone with the session if there is one.
std::string lock_folder() {
    const char* runtime = std::getenv("XDG_RUNTIME_DIR");  // NOLINT(concurrency-mt-unsafe)
    if (runtime != nullptr && *runtime == '/') return std::string(runtime) + "/tactspace";
    return "/tmp/tactspace-" + std::to_string(getuid());
}

// Readable, and another one for every actuator: names of outputs are long, and alike but for their
// signs.
std::string file_name(const std::string& actuator) {
    std::string name;
    for (const char c : actuator) {
        const bool is_plain = std::isalnum(static_cast<unsigned char>(c)) != 0;
        name += is_plain ? c : '_';
    }
    return name.substr(0, 200) + "_" + fingerprint_text(actuator) + ".lock";
}

}  // namespace

Expected<ActuatorLock> ActuatorLock::of(const std::string& id, const std::string& name) {
    const std::string folder = lock_folder();
    mkdir(folder.c_str(), S_IRWXU);
    const std::string file = folder + "/" + file_name(id);
    ActuatorLock lock;
    lock.descriptor_ =
        open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, S_IRUSR | S_IWUSR);
    if (lock.descriptor_ < 0) return lock;
    if (flock(lock.descriptor_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
        return Error{"another tactspace plays on " + name +
                     ": stop it there, as the two would add up"};
    }
    return lock;
}

ActuatorLock::~ActuatorLock() {
    if (descriptor_ >= 0) close(descriptor_);
}

}  // namespace tact
