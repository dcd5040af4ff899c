#include "labs/03_wavefront/scan.h"

#include "labs/03_wavefront/scan_tiles.h"

namespace raylab::lab03 {

ScanFunction* scan_function(ScanKind kind) {
    switch (kind) {
    case ScanKind::serial:
        return scan_serial;
    case ScanKind::naive:
        return scan_naive;
    case ScanKind::efficient:
        return scan_efficient;
    case ScanKind::warp:
        return scan_warp;
    case ScanKind::library:
        return scan_library;
    case ScanKind::lookback:
        return scan_lookback;
    }
    return nullptr;
}

std::int64_t scan_workspace(ScanKind kind, std::int64_t n) {
    switch (kind) {
    case ScanKind::serial:
        return 0;
    case ScanKind::naive:
        return n;
    case ScanKind::efficient:
    case ScanKind::warp:
        return tiled_workspace(n);
    case ScanKind::library:
        return scan_library_workspace(n);
    case ScanKind::lookback:
        return scan_lookback_workspace(n);
    }
    return 0;
}

} // namespace raylab::lab03
