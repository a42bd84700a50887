#include "model/common/thrown.h"

#include <exception>
#include <new>
#include <stdexcept>

namespace tact {

Error thrown_error() {
    const Error no_memory{
        "there is not enough memory for this; fewer or shorter patterns and fewer threads need "
        "less"};
    try {
        throw;
    } catch (const std::bad_alloc&) {
        return no_memory;
    } catch (const std::length_error&) {
        return no_memory;  // more than a container can hold
    } catch (const std::exception& thrown) {
        return Error{std::string("the work failed: ") + thrown.what()};
    } catch (...) {
        return Error{"the work failed"};
    }
}

}  // namespace tact
