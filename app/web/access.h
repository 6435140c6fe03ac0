// Who may talk to the server: those who know its token and whose page came from it.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace quicksand {

// 128 random bits in hexadecimal digits.
std::string random_token();

// The token that a file holds; a new one is written to it, for its owner alone, where there is none. Throws InputError
// if the file cannot be read or written, is open to others, or holds no token.
std::string token_of(const std::filesystem::path& file);

// Takes as long wherever the first difference is.
bool same_secret(std::string_view given, std::string_view secret);

// The value of a cookie in the header `Cookie`; empty if there is none.
std::string_view cookie(std::string_view header, std::string_view name);

// Whether a request was made to this machine by a name that only means it, or by `named`: else a page from elsewhere
// could have let its own name point here.
bool is_our_host(std::string_view host, std::string_view named);

// Whether a page of this origin ("http://HOST:PORT") came from the host that it talks to. None: no page, but a program.
bool is_same_origin(std::string_view origin, std::string_view host);

// Whether the address reaches this machine alone.
bool is_loopback(std::string_view address);
// Whether it stands for all addresses of this machine.
bool is_any_address(std::string_view address);

// A relative name of plain words, a/b.csv: no way up, nothing hidden.
bool is_plain_name(std::string_view name);

}  // namespace quicksand
