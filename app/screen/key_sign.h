// What a key is called: by the sign that it writes in the layout of the keyboard.
#pragma once

namespace tact {

// The ASCII sign a key writes, in lower case; 0: none. The row of digits counts as digits in every
// layout, and one without Latin letters keeps the letters' places of the US one. Codes are GLFW's.
char32_t sign_of(int code, int scancode);

// Keys that write are named by what they write, in capitals; keypad and the others keep their code.
int code_of(int code, char32_t sign);

}  // namespace tact
