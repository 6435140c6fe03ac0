#include "render/draw/painter.h"

#include <cstddef>

#include "quicksand_shaders.h"

namespace quicksand {
namespace {

// How the shapes of a kind lie in memory: a vector of floats, then another or a colour, a colour.
struct ShapeForm {
  std::size_t stride;
  std::array<Attribute, 3> attributes;
};
constexpr std::array<ShapeForm, 3> kForms{{
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

}  // namespace

Painter::Painter()
    : programs_{canvas_.make_program(shaders::kDiskVertex, shaders::kDiskFragment),
                canvas_.make_program(shaders::kSegmentVertex, shaders::kSegmentFragment),
                canvas_.make_program(shaders::kGlyphVertex, shaders::kGlyphFragment)} {
  canvas_.gl().GenTextures(1, &atlas_);
}

void Painter::use_font(const Font& font) {
  canvas_.make_current();
  const GlTable& gl = canvas_.gl();
  gl.ActiveTexture(GL_TEXTURE0);
  gl.BindTexture(GL_TEXTURE_2D, atlas_);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_R8, font.atlas_width(), font.atlas_height(), 0, GL_RED,
                GL_UNSIGNED_BYTE, font.atlas().data());
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

void Painter::upload(const DrawList& list) {
  const GlTable& gl = canvas_.gl();
  const auto fill = [&](DrawList::Kind kind, const auto& shapes) {
    gl.BindBuffer(GL_ARRAY_BUFFER, programs_[static_cast<std::size_t>(kind)].buffer);
    gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(shapes.size() * sizeof(shapes[0])),
                  shapes.data(), GL_STREAM_DRAW);
  };
  fill(DrawList::Kind::disks, list.disks());
  fill(DrawList::Kind::segments, list.segments());
  fill(DrawList::Kind::glyphs, list.glyphs());
}

void Painter::draw(const DrawList::Batch& batch) {
  const auto kind = static_cast<std::size_t>(batch.kind);
  const ShapeForm& form = kForms[kind];
  canvas_.use(programs_[kind], form.attributes, form.stride, true, batch.first * form.stride);
  canvas_.clip_to(batch.clip);
  canvas_.gl().DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(batch.count));
}

Image Painter::paint(const DrawList& list) {
  canvas_.clear(list.width(), list.height(), list.background());
  upload(list);
  for (const DrawList::Batch& batch : list.batches()) draw(batch);
  return canvas_.finish();
}

}  // namespace quicksand
