#include "app/phones/phone_page.h"

#include <string>

#include "assets/assets.h"

namespace tact {

std::vector<PageFile> phone_page() {
    const auto file = [](const char* name, const char* type) {
        const std::string path = std::string("phone/") + name;
        return PageFile{name, std::string(type) + "; charset=utf-8", std::string(asset(path))};
    };
    return {file("index.html", "text/html"), file("phone.js", "text/javascript"),
            file("phone.css", "text/css"), file("texts.json", "application/json")};
}

}  // namespace tact
