#include "listed_page.hpp"

namespace pmts::gui {

void ListedPage::entered() {}

void ListedPage::left() {}

}  // namespace pmts::gui
