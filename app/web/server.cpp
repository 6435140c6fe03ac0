#include "app/web/server.h"

#include <libwebsockets.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <exception>
#include <map>
#include <thread>

#include "app/web/client.h"
#include "app/web/http_request.h"
#include "core/base/errors.h"

namespace quicksand {

struct Server::Impl {
  Impl(ServerOptions o, PageParts p, Exchange& e);
  ~Impl();

  static int on_event(lws* wsi, lws_callback_reasons reason, void* user, void* in,
                      std::size_t size);
  int serve(lws* wsi, lws_callback_reasons reason, void* in, std::size_t size);
  int upgrade(lws* wsi);
  bool has_its_share(const std::string& address) const;
  Access access() const {
    return {options.token, options.host, options.folder, lws_get_vhost_listen_port(vhost)};
  }
  int receive(lws* wsi, const void* in, std::size_t size);
  int send(lws* wsi);
  void spread_answers();

  ServerOptions options;
  PageParts parts;
  Exchange& exchange;
  std::map<lws*, std::string> connected;  // and from which address
  std::map<lws*, Client> clients;
  std::map<lws*, HttpAnswer> http;
  ClientId last_client = kEveryClient;
  lws_retry_bo_t patience{};
  lws_context* context = nullptr;
  lws_vhost* vhost = nullptr;
  std::atomic<bool> ends{false};
  std::thread thread;
};

namespace {

constexpr const char* kProtocol = "quicksand";
constexpr unsigned kMostConnections = 96;

std::string address_of(lws_sockfd_type connection) {
  std::array<char, 64> text{};
  lws_get_peer_simple_fd(connection, text.data(), text.size());
  return text.data();
}

}  // namespace

Server::Impl::Impl(ServerOptions o, PageParts p, Exchange& e)
    : options(std::move(o)), parts(std::move(p)), exchange(e) {
  lws_set_log_level(0, nullptr);
  patience.secs_since_valid_ping = static_cast<std::uint16_t>(options.limits.ping_after);
  patience.secs_since_valid_hangup = static_cast<std::uint16_t>(options.limits.hang_up_after);
  static const lws_protocols protocols[] = {{"http", on_event, 0, 0, 0, nullptr, 0},
                                            {kProtocol, on_event, 0, 0, 0, nullptr, 0},
                                            {nullptr, nullptr, 0, 0, 0, nullptr, 0}};
  lws_context_creation_info info{};
  info.port = options.port;
  info.iface = options.address.c_str();
  info.protocols = protocols;
  info.gid = info.uid = static_cast<decltype(info.gid)>(-1);
  info.user = this;
  info.retry_and_idle_policy = &patience;
  info.timeout_secs = static_cast<unsigned>(options.limits.time_to_ask);
  info.keepalive_timeout = options.limits.time_to_ask;
  info.fd_limit_per_thread = kMostConnections;
  info.options = LWS_SERVER_OPTION_FAIL_UPON_UNABLE_TO_BIND | LWS_SERVER_OPTION_EXPLICIT_VHOSTS;
  if (options.address.find(':') == std::string::npos)
    info.options |= LWS_SERVER_OPTION_DISABLE_IPV6;
  context = lws_create_context(&info);
  if (context != nullptr) vhost = lws_create_vhost(context, &info);
  if (vhost == nullptr) {
    // Whether it would listen there at any port tells what is to be changed.
    info.port = 0;
    const bool listens = context != nullptr && lws_create_vhost(context, &info) != nullptr;
    if (context != nullptr) lws_context_destroy(context);
    if (!listens)
      throw InputError("--listen",
                       options.address + " is not an address of this machine; 127.0.0.1 " +
                           "is reachable from this machine only, 0.0.0.0 from everywhere");
    throw InputError("--port", "cannot listen at " + options.address + ", port " +
                                   std::to_string(options.port) +
                                   "; is it in use? --port 0 picks a free one");
  }
  exchange.wake_server = [this] { lws_cancel_service(context); };
  thread = std::thread([this] {
    while (!ends && lws_service(context, 0) >= 0) {
    }
  });
}

Server::Impl::~Impl() {
  ends = true;
  lws_cancel_service(context);
  thread.join();
  exchange.wake_server = nullptr;
  lws_context_destroy(context);
}

int Server::Impl::on_event(lws* wsi, lws_callback_reasons reason, void* /*user*/, void* in,
                           std::size_t size) {
  lws_context* context = lws_get_context(wsi);
  auto* impl = static_cast<Impl*>(context != nullptr ? lws_context_user(context) : nullptr);
  if (impl == nullptr) return 0;
  try {
    return impl->serve(wsi, reason, in, size);
  } catch (const std::exception&) {
    return -1;  // closes this connection; nothing may be thrown through the library, which is written in C
  }
}

int Server::Impl::serve(lws* wsi, lws_callback_reasons reason, void* in, std::size_t size) {
  switch (reason) {
    case LWS_CALLBACK_FILTER_NETWORK_CONNECTION:
      // It is not adopted yet: what comes in is the number of its socket.
      return has_its_share(address_of(static_cast<int>(reinterpret_cast<std::intptr_t>(in)))) ? 1
                                                                                              : 0;
    case LWS_CALLBACK_SERVER_NEW_CLIENT_INSTANTIATED:
      connected.emplace(wsi, address_of(lws_get_socket_fd(wsi)));
      return 0;
    case LWS_CALLBACK_WSI_DESTROY:
      connected.erase(wsi);
      return 0;
    case LWS_CALLBACK_HTTP: {
      HttpAnswer& answer = http[wsi];
      const HttpRequest request = request_of(wsi);
      answer = answer_to(request, access(), parts);
      answer.head_only = request.is_head;
      return begin_answer(wsi, answer);
    }
    case LWS_CALLBACK_HTTP_WRITEABLE: {
      const auto found = http.find(wsi);
      return found == http.end() ? 0 : go_on_answering(wsi, found->second);
    }
    case LWS_CALLBACK_HTTP_FILE_COMPLETION:
      return lws_http_transaction_completed(wsi) != 0 ? -1 : 0;
    case LWS_CALLBACK_CLOSED_HTTP:
      http.erase(wsi);
      return 0;
    case LWS_CALLBACK_HTTP_CONFIRM_UPGRADE:
      return upgrade(wsi);
    case LWS_CALLBACK_ESTABLISHED:
      clients.try_emplace(wsi, ++last_client, options.limits);
      exchange.want_frame_after(exchange.newest(Newest::frame).number);
      lws_callback_on_writable(wsi);
      return 0;
    case LWS_CALLBACK_RECEIVE:
      return receive(wsi, in, size);
    case LWS_CALLBACK_SERVER_WRITEABLE:
      return send(wsi);
    case LWS_CALLBACK_CLOSED:
      if (const auto gone = clients.find(wsi); gone != clients.end()) {
        exchange.forget(gone->second.id());
        clients.erase(gone);
      }
      return 0;
    case LWS_CALLBACK_EVENT_WAIT_CANCELLED:
      spread_answers();
      return 0;
    default:
      return 0;
  }
}

// One that opens connections and says nothing leaves as many to the others.
bool Server::Impl::has_its_share(const std::string& address) const {
  return std::ranges::count(connected, address, [](const auto& it) { return it.second; }) >=
         kMostConnections / 2;
}

// Before the connection becomes a WebSocket: what is refused here gets an answer in HTTP.
int Server::Impl::upgrade(lws* wsi) {
  const HttpRequest request = request_of(wsi);
  int refusal = refusal_of(request, access());
  if (refusal == 0 && clients.size() >= options.limits.clients)
    refusal = HTTP_STATUS_SERVICE_UNAVAILABLE;
  if (refusal == 0) return 0;
  lws_return_http_status(wsi, static_cast<unsigned>(refusal), nullptr);
  return 1;
}

int Server::Impl::receive(lws* wsi, const void* in, std::size_t size) {
  const auto found = clients.find(wsi);
  if (found == clients.end()) return -1;
  Client& client = found->second;
  const std::string_view piece(static_cast<const char*>(in), size);
  const Client::Heard heard =
      client.hear(piece, lws_frame_is_binary(wsi) != 0,
                  lws_is_final_fragment(wsi) != 0 && lws_remaining_packet_payload(wsi) == 0);
  if (heard == Client::Heard::text && !exchange.give({client.id(), client.take_text()}))
    client.answer(R"({"ok": false, "error": "too many messages are waiting; try again"})");
  if (heard == Client::Heard::seen && client.has_room())
    exchange.want_frame_after(client.last_frame());
  lws_callback_on_writable(wsi);
  return 0;
}

// One message; it is called again when there is room for another.
int Server::Impl::send(lws* wsi) {
  const auto found = clients.find(wsi);
  if (found == clients.end()) return -1;
  Client& client = found->second;
  // Here rather than where it was heard: while a message is partly sent, the library would close
  // without the reason.
  if (client.refusal() != Client::Refusal::none) {
    lws_close_reason(wsi,
                     client.refusal() == Client::Refusal::too_large
                         ? LWS_CLOSE_STATUS_MESSAGE_TOO_LARGE
                         : LWS_CLOSE_STATUS_POLICY_VIOLATION,
                     nullptr, 0);
    return -1;
  }
  const Client::Message message = client.next(exchange);
  if (!message.bytes) return 0;
  // The library writes its own header before the bytes.
  std::string& room = client.room_for(*message.bytes, LWS_PRE);
  const int written =
      lws_write(wsi, reinterpret_cast<unsigned char*>(room.data()) + LWS_PRE, message.bytes->size(),
                message.binary ? LWS_WRITE_BINARY : LWS_WRITE_TEXT);
  if (written < static_cast<int>(message.bytes->size())) return -1;
  lws_callback_on_writable(wsi);
  return 0;
}

void Server::Impl::spread_answers() {
  for (ClientText& answer : exchange.take_answers())
    for (auto& [wsi, client] : clients)
      if (answer.client == kEveryClient || answer.client == client.id()) client.answer(answer.text);
  for (auto& [wsi, client] : clients) {
    if (client.is_stuck()) lws_set_timeout(wsi, PENDING_TIMEOUT_CLOSE_SEND, LWS_TO_KILL_ASYNC);
    lws_callback_on_writable(wsi);
  }
}

Server::Server(ServerOptions options, PageParts parts, Exchange& exchange)
    : impl_(std::make_unique<Impl>(std::move(options), std::move(parts), exchange)) {}

Server::~Server() = default;

int Server::port() const { return lws_get_vhost_listen_port(impl_->vhost); }

}  // namespace quicksand
