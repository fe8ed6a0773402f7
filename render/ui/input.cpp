#include "ui/input.hpp"

#include <map>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace percuss::render {

int key_number(const std::string& name) {
    static const std::map<std::string, int> named{
        {"Space", GLFW_KEY_SPACE},   {"Right", GLFW_KEY_RIGHT},   {"Left", GLFW_KEY_LEFT},
        {"Up", GLFW_KEY_UP},         {"Down", GLFW_KEY_DOWN},     {"Tab", GLFW_KEY_TAB},
        {"Enter", GLFW_KEY_ENTER},   {"Escape", GLFW_KEY_ESCAPE}, {"Backspace", GLFW_KEY_BACKSPACE},
        {"Delete", GLFW_KEY_DELETE}, {"Home", GLFW_KEY_HOME},     {"End", GLFW_KEY_END},
        {"+", GLFW_KEY_EQUAL},       {"-", GLFW_KEY_MINUS},       {"0", GLFW_KEY_0}};
    if (const auto found = named.find(name); found != named.end()) return found->second;
    if (name.size() == 1 && ((name[0] >= 'A' && name[0] <= 'Z') || (name[0] >= '0' && name[0] <= '9')))
        return name[0];  // GLFW's numbers are those of ASCII
    if (name.size() == 2 && name[0] == 'F' && name[1] >= '1' && name[1] <= '9')
        return GLFW_KEY_F1 + (name[1] - '1');
    return 0;
}

}  // namespace percuss::render
