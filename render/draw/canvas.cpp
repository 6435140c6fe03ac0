#include "render/draw/canvas.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "quicksand_shaders.h"
#include "render/base/render_error.h"

namespace quicksand {
namespace {

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

Canvas::Canvas() : gl_(GlTable::load(*context_)) {
  gl_.Enable(GL_BLEND);
  gl_.Enable(GL_SCISSOR_TEST);
  gl_.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  gl_.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
}

void Canvas::make_current(int width, int height) {
  if (has_surface_ && context_->is_current() && width == width_ && height == height_) return;
  has_surface_ = false;
  context_->make_current(width, height);
  has_surface_ = true;
  width_ = width;
  height_ = height;
}

GLuint Canvas::compile(GLenum stage, std::span<const char* const> parts) {
  const GLuint shader = gl_.CreateShader(stage);
  gl_.ShaderSource(shader, static_cast<GLsizei>(parts.size()), parts.data(), nullptr);
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

CanvasProgram Canvas::make_program(const char* vertex, const char* fragment) {
  const std::array<const char*, 2> vertex_parts{shaders::kVertexHead, vertex};
  const std::array<const char*, 1> fragment_parts{fragment};
  const GLuint vertex_shader = compile(GL_VERTEX_SHADER, vertex_parts);
  const GLuint fragment_shader = compile(GL_FRAGMENT_SHADER, fragment_parts);
  CanvasProgram program;
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

void Canvas::clear(int width, int height, Colour background) {
  make_current(width, height);
  gl_.Viewport(0, 0, width, height);
  gl_.Scissor(0, 0, width, height);
  gl_.ClearColor(static_cast<GLfloat>(background.r) / 255, static_cast<GLfloat>(background.g) / 255,
                 static_cast<GLfloat>(background.b) / 255,
                 static_cast<GLfloat>(background.a) / 255);
  gl_.Clear(GL_COLOR_BUFFER_BIT);
}

void Canvas::use(const CanvasProgram& program, std::span<const Attribute> attributes,
                 std::size_t stride, bool per_instance, std::size_t start) {
  gl_.UseProgram(program.id);
  gl_.Uniform2f(program.picture, static_cast<GLfloat>(width_), static_cast<GLfloat>(height_));
  gl_.BindVertexArray(program.vertex_array);
  gl_.BindBuffer(GL_ARRAY_BUFFER, program.buffer);
  for (GLuint i = 0; i < attributes.size(); ++i) {
    const Attribute& attribute = attributes[i];
    gl_.EnableVertexAttribArray(i);
    gl_.VertexAttribPointer(
        i, attribute.size, attribute.type, attribute.type == GL_UNSIGNED_BYTE ? GL_TRUE : GL_FALSE,
        static_cast<GLsizei>(stride),
        // NOLINTNEXTLINE(performance-no-int-to-ptr): an offset, as the GL takes it
        reinterpret_cast<const void*>(start + attribute.offset));
    gl_.VertexAttribDivisor(i, per_instance ? 1 : 0);
  }
}

void Canvas::clip_to(const PixelRect& rect) {
  const auto left = static_cast<GLint>(std::floor(rect.x));
  const auto right = static_cast<GLint>(std::ceil(rect.right()));
  const auto top = static_cast<GLint>(std::floor(rect.y));
  const auto bottom = static_cast<GLint>(std::ceil(rect.bottom()));
  gl_.Scissor(left, height_ - bottom, std::max(0, right - left), std::max(0, bottom - top));
}

Image Canvas::finish() {
  gl_.Finish();
  return to_rgb(context_->pixels(), width_, height_);
}

void Canvas::finish_over(Image& picture) {
  gl_.Finish();
  const std::uint8_t* painted = context_->pixels();
  std::uint8_t* out = picture.rgb.data();
  const std::size_t pixels = picture.rgb.size() / 3;
  for (std::size_t i = 0; i < pixels; ++i, painted += 4, out += 3) {
    const int through = 255 - painted[3];
    if (through == 255) continue;
    for (int channel = 0; channel < 3; ++channel) {
      const int sum = painted[channel] + (out[channel] * through + 127) / 255;
      out[channel] = static_cast<std::uint8_t>(std::min(sum, 255));
    }
  }
}

}  // namespace quicksand
