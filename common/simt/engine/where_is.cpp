// Debug information by libdw (elfutils), of this very process; see where_is.h.
//
// The line table of DWARF says from which line an instruction comes, also where the compiler has
// inlined the function with that line. The tree of entries says what was inlined where: of the
// scopes around an instruction, from the inside, each DW_TAG_inlined_subroutine names the call that
// it stands for.
#include "common/simt/engine/where_is.h"

#include <cxxabi.h>
#include <dlfcn.h>

#include <cstdlib>
#include <cstring>
#include <memory>

#if defined(RAYLAB_HAS_LIBDW)
#include <dwarf.h>
#include <elfutils/libdwfl.h>
#include <mutex>
#include <unistd.h>
#endif

namespace raylab::simt {

static std::string demangled(const char* name) {
    int status = 0;
    std::unique_ptr<char, decltype(&std::free)> text(
        abi::__cxa_demangle(name, nullptr, nullptr, &status), &std::free);
    return status == 0 && text ? text.get() : name;
}

#if defined(RAYLAB_HAS_LIBDW)

namespace {

// What the process had loaded when the first question came.
class DebugInformation {
  public:
    DebugInformation() {
        static char* no_path = nullptr;
        static const Dwfl_Callbacks callbacks = {dwfl_linux_proc_find_elf,
                                                 dwfl_standard_find_debuginfo, nullptr, &no_path};
        dwfl_ = dwfl_begin(&callbacks);
        if (!dwfl_) return;
        dwfl_report_begin(dwfl_);
        dwfl_linux_proc_report(dwfl_, getpid());
        dwfl_report_end(dwfl_, nullptr, nullptr);
    }
    ~DebugInformation() { dwfl_end(dwfl_); }
    DebugInformation(const DebugInformation&) = delete;
    DebugInformation& operator=(const DebugInformation&) = delete;

    Dwfl_Module* module(Dwarf_Addr pc) const {
        return dwfl_ ? dwfl_addrmodule(dwfl_, pc) : nullptr;
    }

    std::mutex mutex;

  private:
    Dwfl* dwfl_ = nullptr;
};

DebugInformation& debug_information() {
    static DebugInformation information;
    return information;
}

// A name as the compiler was given it: libdw puts the folder in front that it ran in.
std::string given_name(Dwarf_Die* unit, const char* file) {
    if (!file) return {};
    std::string name = file;
    Dwarf_Attribute attribute;
    const char* folder = dwarf_formstring(dwarf_attr(unit, DW_AT_comp_dir, &attribute));
    if (folder && name.starts_with(folder) && name[std::string(folder).size()] == '/')
        name.erase(0, std::string(folder).size() + 1);
    while (name.starts_with("./")) name.erase(0, 2);
    return name;
}

bool is_users(const std::string& file) {
    if (file.empty() || file.starts_with("/usr/")) return false;
    const std::size_t machine = file.rfind("common/simt/");
    return machine == file.npos || file.compare(machine, 18, "common/simt/tests/") == 0;
}

int number(Dwarf_Die* entry, unsigned which) {
    Dwarf_Attribute attribute;
    Dwarf_Word value = 0;
    return dwarf_formudata(dwarf_attr(entry, which, &attribute), &value) == 0 ? int(value) : 0;
}

SourcePlace line_at(Dwarf_Die* unit, Dwarf_Addr pc) {
    Dwarf_Line* line = dwarf_getsrc_die(unit, pc);
    SourcePlace place;
    if (!line) return place;
    place.file = given_name(unit, dwarf_linesrc(line, nullptr, nullptr));
    dwarf_lineno(line, &place.line);
    dwarf_linecol(line, &place.column);
    return place;
}

// The call that an inlined subroutine stands for.
SourcePlace call_of(Dwarf_Die* unit, Dwarf_Die* inlined) {
    Dwarf_Files* files = nullptr;
    std::size_t count = 0;
    const int file = number(inlined, DW_AT_call_file);
    if (dwarf_getsrcfiles(unit, &files, &count) != 0 || file < 0 || std::size_t(file) >= count)
        return {};
    return {given_name(unit, dwarf_filesrc(files, std::size_t(file), nullptr, nullptr)),
            number(inlined, DW_AT_call_line), number(inlined, DW_AT_call_column)};
}

// The unit with the instruction, whose address in the file is address - bias. g++ writes a table of
// the units' addresses; clang does not, and then each unit is asked.
Dwarf_Die* unit_at(Dwfl_Module* module, Dwarf_Addr address, Dwarf_Addr& bias) {
    if (Dwarf_Die* unit = dwfl_module_addrdie(module, address, &bias)) return unit;
    for (Dwarf_Die* unit = nullptr; (unit = dwfl_module_nextcu(module, unit, &bias));)
        if (dwarf_haspc(unit, address - bias) > 0) return unit;
    return nullptr;
}

bool is_of_the_system(Dwfl_Module* module) {
    const char* file =
        dwfl_module_info(module, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr);
    return file && (!std::strncmp(file, "/usr/lib", 8) || !std::strncmp(file, "/lib", 4));
}

} // namespace

std::optional<SourcePlace> source_place(const void* pc) {
    DebugInformation& information = debug_information();
    std::lock_guard lock(information.mutex);
    const auto address = Dwarf_Addr(pc);
    Dwfl_Module* module = information.module(address);
    if (!module || is_of_the_system(module)) return {};
    Dwarf_Addr bias = 0;
    Dwarf_Die* unit = unit_at(module, address, bias);
    if (!unit) return {};
    SourcePlace place = line_at(unit, address - bias);
    Dwarf_Die* scopes = nullptr;
    int count = is_users(place.file) ? 0 : dwarf_getscopes(unit, address - bias, &scopes);
    if (count > 0) {
        // Those are the scopes in which the innermost function is written; these, where it was
        // inlined.
        Dwarf_Die innermost = scopes[0];
        std::free(scopes);
        scopes = nullptr;
        count = dwarf_getscopes_die(&innermost, &scopes);
    }
    for (int i = 0; i < count && !is_users(place.file); ++i)
        if (dwarf_tag(&scopes[i]) == DW_TAG_inlined_subroutine) place = call_of(unit, &scopes[i]);
    std::free(scopes);
    if (!is_users(place.file) || place.line <= 0) return {};
    return place;
}

std::string function_name(const void* pc) {
    DebugInformation& information = debug_information();
    std::lock_guard lock(information.mutex);
    Dwfl_Module* module = information.module(Dwarf_Addr(pc));
    const char* name = module ? dwfl_module_addrname(module, Dwarf_Addr(pc)) : nullptr;
    return name ? demangled(name) : std::string();
}

std::optional<Variable> variable_at(const void* address) {
    DebugInformation& information = debug_information();
    std::lock_guard lock(information.mutex);
    Dwfl_Module* module = information.module(Dwarf_Addr(address));
    GElf_Sym symbol;
    GElf_Off offset = 0;
    const char* name = module ? dwfl_module_addrinfo(module, Dwarf_Addr(address), &offset, &symbol,
                                                     nullptr, nullptr, nullptr)
                              : nullptr;
    if (!name || GELF_ST_TYPE(symbol.st_info) != STT_OBJECT) return {};
    std::string text = demangled(name); // k(float*)::words
    if (const std::size_t scope = text.rfind("::"); scope != text.npos) text.erase(0, scope + 2);
    return Variable{text, offset, symbol.st_size};
}

#else

std::optional<Variable> variable_at(const void*) { return {}; }

std::optional<SourcePlace> source_place(const void*) { return {}; }

std::string function_name(const void* pc) {
    Dl_info found;
    return dladdr(pc, &found) && found.dli_sname ? demangled(found.dli_sname) : std::string();
}

#endif

} // namespace raylab::simt
