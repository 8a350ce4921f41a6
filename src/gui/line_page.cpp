#include "line_page.hpp"

namespace pmts::gui {

void LinePage::entered() {}

void LinePage::left() {}

}  // namespace pmts::gui
