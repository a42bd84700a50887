// The header of OpenGL: of 3.0 on a desktop, of ES 3.0 in a browser, which has all that is called
// here.
#pragma once

#ifdef __EMSCRIPTEN__
#include <GLES3/gl3.h>
#else
#include <epoxy/gl.h>
#endif
