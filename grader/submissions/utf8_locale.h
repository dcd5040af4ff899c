// While an object of this class lives, this thread's texts are UTF-8 to the C library. libarchive
// turns names into the locale's characters, and a program starts in one that has ASCII alone.
#pragma once

#include <clocale>
#if defined(__APPLE__)
#include <xlocale.h>
#endif

namespace raylab {

class Utf8Locale {
  public:
    Utf8Locale() {
        for (const char* name : {"C.UTF-8", "UTF-8", "en_US.UTF-8"})
            if (!own_) own_ = newlocale(LC_CTYPE_MASK, name, locale_t());
        if (own_) before_ = uselocale(own_);
    }
    ~Utf8Locale() {
        if (!own_) return;
        uselocale(before_);
        freelocale(own_);
    }
    Utf8Locale(const Utf8Locale&) = delete;
    Utf8Locale& operator=(const Utf8Locale&) = delete;

  private:
    locale_t own_ = locale_t(), before_ = locale_t();
};

} // namespace raylab
