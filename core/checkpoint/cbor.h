// What a checkpoint's bytes will be before they are parsed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace quicksand {

// The number of items, nested ones included, of the one item that `bytes` are. Throws std::runtime_error where it
// is cut short, nested deeper than any checkpoint, or of a kind that none holds: tags and indefinite lengths.
// The parser recurses with the nesting, and would overflow the stack; of nested strings of indefinite length it tells
// no handler of its events before it does.
std::size_t count_cbor_items(std::span<const std::uint8_t> bytes);

}  // namespace quicksand
