// libstdc++'s shortest text of a double for `kyvadlo-bench --scenes`.
#include <charconv>

extern "C" int kyvadlo_to_chars(double value, char *text, int size)
{
   return static_cast<int>(std::to_chars(text, text + size, value, std::chars_format::scientific).ptr - text);
}
