// The GL functions that are used here, loaded at run time: linking libGL beside OSMesa would turn
// every call into nothing, without an error.
#pragma once

#include <GL/glcorearb.h>

#include "render/gl/offscreen.h"

namespace quicksand {

// name, in the spelling of the GL without its prefix; the type follows from it
#define QUICKSAND_GL_FUNCTIONS(X)                     \
  X(ActiveTexture, ACTIVETEXTURE)                     \
  X(AttachShader, ATTACHSHADER)                       \
  X(BindBuffer, BINDBUFFER)                           \
  X(BindTexture, BINDTEXTURE)                         \
  X(BindVertexArray, BINDVERTEXARRAY)                 \
  X(BlendFunc, BLENDFUNC)                             \
  X(BlendFuncSeparate, BLENDFUNCSEPARATE)             \
  X(BufferData, BUFFERDATA)                           \
  X(Clear, CLEAR)                                     \
  X(ClearColor, CLEARCOLOR)                           \
  X(CompileShader, COMPILESHADER)                     \
  X(CreateProgram, CREATEPROGRAM)                     \
  X(CreateShader, CREATESHADER)                       \
  X(DeleteShader, DELETESHADER)                       \
  X(DrawArraysInstanced, DRAWARRAYSINSTANCED)         \
  X(DrawElements, DRAWELEMENTS)                       \
  X(Enable, ENABLE)                                   \
  X(EnableVertexAttribArray, ENABLEVERTEXATTRIBARRAY) \
  X(Finish, FINISH)                                   \
  X(GenBuffers, GENBUFFERS)                           \
  X(GenTextures, GENTEXTURES)                         \
  X(GenVertexArrays, GENVERTEXARRAYS)                 \
  X(GetProgramInfoLog, GETPROGRAMINFOLOG)             \
  X(GetProgramiv, GETPROGRAMIV)                       \
  X(GetShaderInfoLog, GETSHADERINFOLOG)               \
  X(GetShaderiv, GETSHADERIV)                         \
  X(GetUniformLocation, GETUNIFORMLOCATION)           \
  X(LinkProgram, LINKPROGRAM)                         \
  X(PixelStorei, PIXELSTOREI)                         \
  X(Scissor, SCISSOR)                                 \
  X(ShaderSource, SHADERSOURCE)                       \
  X(TexImage2D, TEXIMAGE2D)                           \
  X(TexParameteri, TEXPARAMETERI)                     \
  X(Uniform2f, UNIFORM2F)                             \
  X(UseProgram, USEPROGRAM)                           \
  X(VertexAttribDivisor, VERTEXATTRIBDIVISOR)         \
  X(VertexAttribPointer, VERTEXATTRIBPOINTER)         \
  X(Viewport, VIEWPORT)

struct GlTable {
#define QUICKSAND_GL_MEMBER(name, type) PFNGL##type##PROC name = nullptr;
  QUICKSAND_GL_FUNCTIONS(QUICKSAND_GL_MEMBER)
#undef QUICKSAND_GL_MEMBER

  // Throws RenderError, naming the function, if one is missing.
  static GlTable load(const Offscreen& context);
};

}  // namespace quicksand
