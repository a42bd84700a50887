#include "app/screen/parts.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace tact {

char32_t sign_of(int code, int scancode) {
    if (code == GLFW_KEY_SPACE) return U' ';
    const char* name = glfwGetKeyName(code, scancode);
    if (name == nullptr) return 0;
    const bool is_ascii = name[0] > ' ' && name[0] < 127 && name[1] == '\0';
    const bool is_digit_key = code >= GLFW_KEY_0 && code <= GLFW_KEY_9;
    const bool is_letter_key = code >= GLFW_KEY_A && code <= GLFW_KEY_Z;
    char32_t sign = is_ascii ? static_cast<char32_t>(name[0]) : 0;
    if (is_digit_key || (is_letter_key && !is_ascii)) sign = static_cast<char32_t>(code);
    return sign >= U'A' && sign <= U'Z' ? sign - U'A' + U'a' : sign;
}

int code_of(int code, char32_t sign) {
    const bool writes = code == GLFW_KEY_UNKNOWN || code < GLFW_KEY_ESCAPE;
    if (!writes || sign == 0) return code;
    return static_cast<int>(sign >= U'a' && sign <= U'z' ? sign - U'a' + U'A' : sign);
}

}  // namespace tact
