#include "app/web/http_request.h"

#include <libwebsockets.h>

#include <algorithm>
#include <array>
#include <utility>

#include "app/run_folder/run_folder.h"
#include "app/web/access.h"

namespace quicksand {

namespace {

constexpr std::string_view kFiles = "/files/";
constexpr std::size_t kPiece = 16384;  // of a body [bytes]

constexpr auto kHeaders = std::to_array<std::pair<const char*, const char*>>(
    {{"content-security-policy:",
      "default-src 'none'; script-src 'self'; style-src 'self'; font-src 'self'; img-src 'self' "
      "blob:; connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'"},
     {"x-content-type-options:", "nosniff"},
     {"referrer-policy:", "no-referrer"},
     {"cross-origin-resource-policy:", "same-origin"},
     {"cross-origin-opener-policy:", "same-origin"},
     {"cache-control:", "no-store"}});

std::string header(lws* wsi, lws_token_indexes which) {
  const int size = lws_hdr_total_length(wsi, which);
  if (size <= 0) return {};
  std::string text(static_cast<std::size_t>(size) + 1, '\0');
  if (lws_hdr_copy(wsi, text.data(), size + 1, which) < 0) return {};
  text.resize(static_cast<std::size_t>(size));
  return text;
}

// Cookies know no ports: two servers on a machine must not take each other's.
std::string cookie_name(int port) { return "quicksand_" + std::to_string(port); }

HttpAnswer text_answer(int status, std::string text) {
  HttpAnswer answer;
  answer.status = status;
  answer.body = std::make_shared<const std::string>(std::move(text));
  return answer;
}

HttpAnswer refusal(int status) {
  switch (status) {
    case HTTP_STATUS_UNAUTHORIZED:
      return text_answer(status,
                         "401: open the address that `quicksand serve` printed, with its token.\n");
    case HTTP_STATUS_METHOD_NOT_ALLOWED:
      return text_answer(status, "405: only GET and HEAD.\n");
    default:
      return text_answer(status, "403: this host name or origin is not allowed; see --host.\n");
  }
}

}  // namespace

HttpRequest request_of(lws* wsi) {
  HttpRequest request;
  request.is_head = lws_hdr_total_length(wsi, WSI_TOKEN_HEAD_URI) > 0;
  request.is_get = request.is_head || lws_hdr_total_length(wsi, WSI_TOKEN_GET_URI) > 0;
  request.path = header(wsi, request.is_head ? WSI_TOKEN_HEAD_URI : WSI_TOKEN_GET_URI);
  request.host = header(wsi, WSI_TOKEN_HOST);
  request.origin = header(wsi, WSI_TOKEN_ORIGIN);
  request.cookies = header(wsi, WSI_TOKEN_HTTP_COOKIE);
  std::array<char, 256> token{};
  if (const char* found = lws_get_urlarg_by_name(wsi, "token=", token.data(), token.size() - 1))
    request.token = found;
  return request;
}

int refusal_of(const HttpRequest& request, const Access& access) {
  if (!request.is_get) return HTTP_STATUS_METHOD_NOT_ALLOWED;
  if (!is_our_host(request.host, access.host) || !is_same_origin(request.origin, request.host))
    return HTTP_STATUS_FORBIDDEN;
  const std::string_view kept = cookie(request.cookies, cookie_name(access.port));
  // Both are compared, always.
  const bool by_address = same_secret(request.token, access.token);
  const bool by_cookie = same_secret(kept, access.token);
  return by_address || by_cookie ? 0 : HTTP_STATUS_UNAUTHORIZED;
}

HttpAnswer answer_to(const HttpRequest& request, const Access& access, const PageParts& parts) {
  if (const int status = refusal_of(request, access); status != 0) return refusal(status);
  if (const auto part = parts.find(request.path); part != parts.end()) {
    HttpAnswer answer;
    answer.type = part->second.type;
    answer.body = part->second.bytes;
    if (!request.token.empty())
      answer.cookie =
          cookie_name(access.port) + "=" + access.token + "; Path=/; HttpOnly; SameSite=Strict";
    return answer;
  }
  if (request.path.starts_with(kFiles)) {
    const std::string name = request.path.substr(kFiles.size());
    std::error_code error;
    const std::filesystem::path file = access.folder / name;
    // A link could lead out of the folder.
    if (is_plain_name(name) && leads_into(access.folder, file) &&
        std::filesystem::is_regular_file(file, error)) {
      HttpAnswer answer;
      answer.type = content_type(name);
      answer.file = file;
      return answer;
    }
  }
  return text_answer(HTTP_STATUS_NOT_FOUND, "404: there is no such file.\n");
}

int begin_answer(lws* wsi, HttpAnswer& answer) {
  std::array<unsigned char, LWS_PRE + 4096> room{};
  unsigned char* const start = &room[LWS_PRE];
  unsigned char* end = room.data() + room.size() - 1;
  unsigned char* at = start;
  const auto add = [&](const char* name, const std::string& value) {
    return lws_add_http_header_by_name(wsi, reinterpret_cast<const unsigned char*>(name),
                                       reinterpret_cast<const unsigned char*>(value.data()),
                                       static_cast<int>(value.size()), &at, end) != 0;
  };
  const auto add_all = [&] {
    bool failed = false;
    for (const auto& [name, value] : kHeaders) failed = add(name, value) || failed;
    if (!answer.cookie.empty()) failed = add("set-cookie:", answer.cookie) || failed;
    return failed;
  };
  const bool of_file = !answer.file.empty();
  if (of_file && !answer.head_only) {
    if (add_all() || add("content-disposition:", "attachment")) return -1;
    const int sent =
        lws_serve_http_file(wsi, answer.file.c_str(), answer.type.c_str(),
                            reinterpret_cast<const char*>(start), static_cast<int>(at - start));
    if (sent < 0) return -1;
    return sent > 0 && lws_http_transaction_completed(wsi) != 0 ? -1 : 0;
  }
  std::error_code gone;  // since the answer was made
  const std::uintmax_t size =
      of_file ? std::filesystem::file_size(answer.file, gone) : answer.body->size();
  if (gone || lws_add_http_common_headers(wsi, static_cast<unsigned>(answer.status),
                                          answer.type.c_str(), size, &at, end) != 0)
    return -1;
  if (add_all() || (of_file && add("content-disposition:", "attachment")) ||
      lws_finalize_write_http_header(wsi, start, &at, end) != 0)
    return -1;
  if (answer.head_only) return lws_http_transaction_completed(wsi) != 0 ? -1 : 0;
  lws_callback_on_writable(wsi);
  return 0;
}

int go_on_answering(lws* wsi, HttpAnswer& answer) {
  if (!answer.body) return 0;
  const std::string& body = *answer.body;
  const std::size_t size = std::min(kPiece, body.size() - answer.sent);
  const bool last = answer.sent + size == body.size();
  std::string room(LWS_PRE, '\0');
  room.append(body, answer.sent, size);
  answer.sent += size;
  if (lws_write(wsi, reinterpret_cast<unsigned char*>(room.data()) + LWS_PRE, size,
                last ? LWS_WRITE_HTTP_FINAL : LWS_WRITE_HTTP) < static_cast<int>(size))
    return -1;
  if (!last) {
    lws_callback_on_writable(wsi);
    return 0;
  }
  answer.body.reset();
  return lws_http_transaction_completed(wsi) != 0 ? -1 : 0;
}

}  // namespace quicksand
