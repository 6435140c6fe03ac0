// The GL functions that are used here, loaded at run time: linking libGL beside OSMesa would turn
// every call into nothing, without an error.
#pragma once

#define GL_GLEXT_PROTOTYPES  // declares the functions, whose types the table takes
#include <GL/glcorearb.h>

#include "render/gl/offscreen.h"

namespace quicksand {

// Names without the prefix of the GL.
// clang-format off
#define QUICKSAND_GL_FUNCTIONS(X)                                                         \
  X(ActiveTexture) X(AttachShader) X(BindBuffer) X(BindTexture) X(BindVertexArray)        \
  X(BlendFunc) X(BlendFuncSeparate) X(BufferData) X(Clear) X(ClearColor) X(CompileShader) \
  X(CreateProgram) X(CreateShader) X(DeleteShader) X(DrawArraysInstanced) X(DrawElements) \
  X(Enable) X(EnableVertexAttribArray) X(Finish) X(GenBuffers) X(GenTextures)             \
  X(GenVertexArrays) X(GetProgramInfoLog) X(GetProgramiv) X(GetShaderInfoLog)             \
  X(GetShaderiv) X(GetUniformLocation) X(LinkProgram) X(PixelStorei) X(Scissor)           \
  X(ShaderSource) X(TexImage2D) X(TexParameteri) X(Uniform2f) X(UseProgram)               \
  X(VertexAttribDivisor) X(VertexAttribPointer) X(Viewport)
// clang-format on

struct GlTable {
// NOLINTNEXTLINE(bugprone-macro-parentheses): a name that is declared cannot be in any.
#define QUICKSAND_GL_MEMBER(name) decltype(&::gl##name) name = nullptr;
  QUICKSAND_GL_FUNCTIONS(QUICKSAND_GL_MEMBER)
#undef QUICKSAND_GL_MEMBER

  // Throws RenderError, naming the function, if one is missing.
  static GlTable load(const GlContext& context);
};

}  // namespace quicksand
