// The window by SDL2 and its software surface, without GL: the pixels are those of the offscreen
// pictures. The only file that knows SDL; built as a module.
#include <SDL2/SDL.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "app/window/display.h"

namespace quicksand {

namespace {

constexpr auto kKeys =
    std::to_array<std::pair<SDL_Scancode, Key>>({{SDL_SCANCODE_TAB, Key::tab},
                                                 {SDL_SCANCODE_LEFT, Key::left},
                                                 {SDL_SCANCODE_RIGHT, Key::right},
                                                 {SDL_SCANCODE_UP, Key::up},
                                                 {SDL_SCANCODE_DOWN, Key::down},
                                                 {SDL_SCANCODE_PAGEUP, Key::page_up},
                                                 {SDL_SCANCODE_PAGEDOWN, Key::page_down},
                                                 {SDL_SCANCODE_HOME, Key::home},
                                                 {SDL_SCANCODE_END, Key::end},
                                                 {SDL_SCANCODE_INSERT, Key::insert},
                                                 {SDL_SCANCODE_DELETE, Key::erase},
                                                 {SDL_SCANCODE_BACKSPACE, Key::backspace},
                                                 {SDL_SCANCODE_SPACE, Key::space},
                                                 {SDL_SCANCODE_RETURN, Key::enter},
                                                 {SDL_SCANCODE_KP_ENTER, Key::enter},
                                                 {SDL_SCANCODE_ESCAPE, Key::escape},
                                                 {SDL_SCANCODE_LCTRL, Key::control},
                                                 {SDL_SCANCODE_RCTRL, Key::control},
                                                 {SDL_SCANCODE_LSHIFT, Key::shift},
                                                 {SDL_SCANCODE_RSHIFT, Key::shift},
                                                 {SDL_SCANCODE_LALT, Key::alt},
                                                 {SDL_SCANCODE_RALT, Key::alt}});

// Shortcuts go by the letter on the key, wherever the layout has it.
constexpr auto kLetters = std::to_array<std::pair<SDL_Keycode, Key>>({{SDLK_a, Key::a},
                                                                      {SDLK_c, Key::c},
                                                                      {SDLK_v, Key::v},
                                                                      {SDLK_x, Key::x},
                                                                      {SDLK_y, Key::y},
                                                                      {SDLK_z, Key::z}});

std::optional<std::size_t> button_of(int sdl) {
  if (sdl == SDL_BUTTON_LEFT) return 0;
  if (sdl == SDL_BUTTON_RIGHT) return 1;
  if (sdl == SDL_BUTTON_MIDDLE) return 2;
  return std::nullopt;
}

std::optional<Key> key_of(const SDL_Keysym& sym) {
  for (const auto& [code, key] : kKeys)
    if (sym.scancode == code) return key;
  for (const auto& [code, key] : kLetters)
    if (sym.sym == code) return key;
  return std::nullopt;
}

class SdlDisplay : public Display {
 public:
  // Takes the window and the running SDL.
  explicit SdlDisplay(SDL_Window* window) : window_(window) { SDL_StartTextInput(); }
  ~SdlDisplay() override {
    SDL_DestroyWindow(window_);
    SDL_Quit();
  }
  SdlDisplay(const SdlDisplay&) = delete;
  SdlDisplay& operator=(const SdlDisplay&) = delete;

  bool poll(GuiInput& input, int wait_milliseconds) override {
    input.text.clear();
    input.wheel = 0;
    happened_ = !late_.empty();
    // A button or key that went down and up since the last frame would never be seen: it stays down for
    // this frame.
    pressed_now_.clear();
    std::vector<SDL_Event> events = std::exchange(late_, {});
    SDL_Event event;
    if (events.empty() && SDL_WaitEventTimeout(&event, wait_milliseconds) != 0)
      events.push_back(event);
    while (SDL_PollEvent(&event) != 0) events.push_back(event);
    for (const SDL_Event& one : events) {
      if (one.type == SDL_QUIT) return false;
      happened_ = true;
      take(one, input);
    }
    return true;
  }

  bool something_happened() const override { return happened_; }

  int width() const override { return size().first; }
  int height() const override { return size().second; }

  void present(const Image& picture) override {
    SDL_Surface* surface = SDL_GetWindowSurface(window_);
    if (surface == nullptr) return;
    SDL_Surface* ours = SDL_CreateRGBSurfaceWithFormatFrom(
        const_cast<std::uint8_t*>(picture.rgb.data()), picture.width, picture.height, 24,
        3 * picture.width, SDL_PIXELFORMAT_RGB24);
    if (ours == nullptr) return;
    SDL_FillRect(surface, nullptr, 0);
    SDL_BlitSurface(ours, nullptr, surface, nullptr);
    SDL_FreeSurface(ours);
    SDL_UpdateWindowSurface(window_);
  }

 private:
  std::pair<int, int> size() const {
    int width = 0, height = 0;
    SDL_GetWindowSize(window_, &width, &height);
    return {width, height};
  }

  void take(const SDL_Event& event, GuiInput& input) {
    switch (event.type) {
      case SDL_MOUSEMOTION:
        input.mouse = {event.motion.x, event.motion.y};
        break;
      case SDL_MOUSEWHEEL:
        input.wheel += event.wheel.y;
        break;
      case SDL_MOUSEBUTTONDOWN:
      case SDL_MOUSEBUTTONUP:
        if (const auto button = button_of(event.button.button)) {
          const int id = kButtonIds + static_cast<int>(*button);
          if (is_late(event, id, event.type == SDL_MOUSEBUTTONUP)) break;
          input.mouse = {event.button.x, event.button.y};
          input.buttons.at(*button) = event.type == SDL_MOUSEBUTTONDOWN;
        }
        break;
      case SDL_KEYDOWN:
      case SDL_KEYUP:
        if (const auto key = key_of(event.key.keysym)) {
          if (is_late(event, static_cast<int>(*key), event.type == SDL_KEYUP)) break;
          std::erase(input.keys, *key);
          if (event.type == SDL_KEYDOWN) input.keys.push_back(*key);
        }
        break;
      case SDL_TEXTINPUT:
        input.text += event.text.text;
        break;
      case SDL_WINDOWEVENT:
        if (event.window.event == SDL_WINDOWEVENT_LEAVE) input.mouse = {-1, -1};
        if (event.window.event == SDL_WINDOWEVENT_FOCUS_LOST) {
          input.keys.clear();
          input.buttons = {};
        }
        break;
      default:
        break;
    }
  }

  // Keeps the end of a press that began in this frame, and all that happens to it after, for the next.
  bool is_late(const SDL_Event& event, int id, bool release) {
    const bool pressed = std::ranges::find(pressed_now_, id) != pressed_now_.end();
    if (!pressed) {
      if (!release) pressed_now_.push_back(id);
      return false;
    }
    const bool repeat = event.type == SDL_KEYDOWN && event.key.repeat != 0;
    if (!repeat) late_.push_back(event);
    return true;
  }

  static constexpr int kButtonIds = 1000;  // beyond the keys

  SDL_Window* window_;
  std::vector<int> pressed_now_;
  std::vector<SDL_Event> late_;
  bool happened_ = false;
};

}  // namespace

}  // namespace quicksand

// See kOpenDisplay.
extern "C" quicksand::Display* quicksand_open_display(const char* title, int width, int height,
                                                      const char** reason) {
  constexpr int kLeastWidth = 640, kLeastHeight = 400;
  SDL_SetHint(SDL_HINT_FRAMEBUFFER_ACCELERATION, "0");
  SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");  // Ctrl-C is the program's
  if (SDL_Init(SDL_INIT_VIDEO) != 0) {
    *reason = SDL_GetError();
    return nullptr;
  }
  SDL_Window* window = SDL_CreateWindow(title, SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED,
                                        width, height, SDL_WINDOW_RESIZABLE);
  if (window == nullptr) {
    *reason = SDL_GetError();
    SDL_Quit();
    return nullptr;
  }
  SDL_SetWindowMinimumSize(window, kLeastWidth, kLeastHeight);
  return new quicksand::SdlDisplay(window);
}
