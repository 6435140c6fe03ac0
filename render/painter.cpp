#include "render/painter.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

#include "render/render_error.h"
#include "render/shaders.h"

namespace quicksand {
namespace {

// How the shapes of a kind lie in memory: a vector of floats, then another or a colour, a colour.
struct Attribute {
  GLint size;
  GLenum type;
  std::size_t offset;
};
struct Layout {
  std::size_t stride;
  std::array<Attribute, 3> attributes;
};
constexpr std::array<Layout, 3> kLayouts{{
    {sizeof(DiskShape),
     {{{4, GL_FLOAT, offsetof(DiskShape, x)},
       {4, GL_UNSIGNED_BYTE, offsetof(DiskShape, fill)},
       {4, GL_UNSIGNED_BYTE, offsetof(DiskShape, outline)}}}},
    {sizeof(SegmentShape),
     {{{4, GL_FLOAT, offsetof(SegmentShape, x0)},
       {2, GL_FLOAT, offsetof(SegmentShape, width)},
       {4, GL_UNSIGNED_BYTE, offsetof(SegmentShape, colour)}}}},
    {sizeof(GlyphShape),
     {{{4, GL_FLOAT, offsetof(GlyphShape, x)},
       {2, GL_FLOAT, offsetof(GlyphShape, u)},
       {4, GL_UNSIGNED_BYTE, offsetof(GlyphShape, colour)}}}},
}};

// Drops the opacity.
Image to_rgb(const std::uint8_t* rgba, int width, int height) {
  Image image(width, height);
  const std::size_t pixels = image.rgb.size() / 3;
  std::uint8_t* out = image.rgb.data();
  for (std::size_t i = 0; i < pixels; ++i) {
    out[3 * i] = rgba[4 * i];
    out[3 * i + 1] = rgba[4 * i + 1];
    out[3 * i + 2] = rgba[4 * i + 2];
  }
  return image;
}

}  // namespace

Painter::Painter() : gl_(GlTable::load(&Offscreen::function)) {
  programs_ = {make_program(shaders::kDiskVertex, shaders::kDiskFragment),
               make_program(shaders::kSegmentVertex, shaders::kSegmentFragment),
               make_program(shaders::kGlyphVertex, shaders::kGlyphFragment)};
  gl_.GenTextures(1, &atlas_);
  gl_.Enable(GL_BLEND);
  gl_.Enable(GL_SCISSOR_TEST);
  gl_.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
}

GLuint Painter::compile(GLenum stage, const char* const* parts, int count) {
  const GLuint shader = gl_.CreateShader(stage);
  gl_.ShaderSource(shader, count, parts, nullptr);
  gl_.CompileShader(shader);
  GLint done = 0;
  gl_.GetShaderiv(shader, GL_COMPILE_STATUS, &done);
  if (done != GL_TRUE) {
    std::string log(1000, '\0');
    gl_.GetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
    throw RenderError("the OpenGL of this system refuses a program: " + log);
  }
  return shader;
}

Painter::Program Painter::make_program(const char* vertex, const char* fragment) {
  const std::array<const char*, 2> vertex_parts{shaders::kVertexHead, vertex};
  const GLuint vertex_shader = compile(GL_VERTEX_SHADER, vertex_parts.data(), 2);
  const GLuint fragment_shader = compile(GL_FRAGMENT_SHADER, &fragment, 1);
  Program program;
  program.id = gl_.CreateProgram();
  gl_.AttachShader(program.id, vertex_shader);
  gl_.AttachShader(program.id, fragment_shader);
  gl_.LinkProgram(program.id);
  gl_.DeleteShader(vertex_shader);
  gl_.DeleteShader(fragment_shader);
  GLint done = 0;
  gl_.GetProgramiv(program.id, GL_LINK_STATUS, &done);
  if (done != GL_TRUE) {
    std::string log(1000, '\0');
    gl_.GetProgramInfoLog(program.id, static_cast<GLsizei>(log.size()), nullptr, log.data());
    throw RenderError("the OpenGL of this system cannot link a program: " + log);
  }
  program.picture = gl_.GetUniformLocation(program.id, "picture");
  gl_.GenVertexArrays(1, &program.vertex_array);
  gl_.GenBuffers(1, &program.buffer);
  return program;
}

void Painter::use_font(const Font& font) {
  offscreen_.make_current();
  gl_.ActiveTexture(GL_TEXTURE0);
  gl_.BindTexture(GL_TEXTURE_2D, atlas_);
  gl_.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_R8, font.atlas_width(), font.atlas_height(), 0, GL_RED,
                 GL_UNSIGNED_BYTE, font.atlas().data());
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

void Painter::upload(const DrawList& list) {
  const auto fill = [&](DrawList::Kind kind, const auto& shapes) {
    gl_.BindBuffer(GL_ARRAY_BUFFER, programs_[static_cast<std::size_t>(kind)].buffer);
    gl_.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(shapes.size() * sizeof(shapes[0])),
                   shapes.data(), GL_STREAM_DRAW);
  };
  fill(DrawList::Kind::disks, list.disks());
  fill(DrawList::Kind::segments, list.segments());
  fill(DrawList::Kind::glyphs, list.glyphs());
}

void Painter::draw(const DrawList& list, const DrawList::Batch& batch) {
  const auto kind = static_cast<std::size_t>(batch.kind);
  const Program& program = programs_[kind];
  const Layout& layout = kLayouts[kind];
  gl_.UseProgram(program.id);
  gl_.Uniform2f(program.picture, static_cast<GLfloat>(list.width()),
                static_cast<GLfloat>(list.height()));
  gl_.BindVertexArray(program.vertex_array);
  gl_.BindBuffer(GL_ARRAY_BUFFER, program.buffer);
  for (GLuint i = 0; i < layout.attributes.size(); ++i) {
    const Attribute& attribute = layout.attributes[i];
    gl_.EnableVertexAttribArray(i);
    gl_.VertexAttribPointer(
        i, attribute.size, attribute.type, attribute.type == GL_UNSIGNED_BYTE ? GL_TRUE : GL_FALSE,
        static_cast<GLsizei>(layout.stride),
        // NOLINTNEXTLINE(performance-no-int-to-ptr): an offset, as the GL takes it
        reinterpret_cast<const void*>(batch.first * layout.stride + attribute.offset));
    gl_.VertexAttribDivisor(i, 1);
  }
  const auto left = static_cast<GLint>(std::floor(batch.clip.x));
  const auto right = static_cast<GLint>(std::ceil(batch.clip.right()));
  const auto top = static_cast<GLint>(std::floor(batch.clip.y));
  const auto bottom = static_cast<GLint>(std::ceil(batch.clip.bottom()));
  gl_.Scissor(left, list.height() - bottom, std::max(0, right - left), std::max(0, bottom - top));
  gl_.DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(batch.count));
}

Image Painter::paint(const DrawList& list) {
  offscreen_.make_current(list.width(), list.height());
  gl_.Viewport(0, 0, list.width(), list.height());
  gl_.Scissor(0, 0, list.width(), list.height());
  const Colour background = list.background();
  gl_.ClearColor(static_cast<GLfloat>(background.r) / 255, static_cast<GLfloat>(background.g) / 255,
                 static_cast<GLfloat>(background.b) / 255, 1);
  gl_.Clear(GL_COLOR_BUFFER_BIT);
  upload(list);
  for (const DrawList::Batch& batch : list.batches()) draw(list, batch);
  gl_.Finish();
  return to_rgb(offscreen_.pixels(), list.width(), list.height());
}

}  // namespace quicksand
