#include "control/base/result.h"

namespace halbench {

std::string_view errorCodeName(ErrorCode code) {
    switch (code) {
    case ErrorCode::Usage:
        return "usage";
    case ErrorCode::UnknownName:
        return "unknown_name";
    case ErrorCode::OutOfRange:
        return "out_of_range";
    case ErrorCode::NotFinite:
        return "not_finite";
    case ErrorCode::InvalidInput:
        return "invalid_input";
    case ErrorCode::FileSystem:
        return "file_system";
    case ErrorCode::Refused:
        return "refused";
    case ErrorCode::DeviceLost:
        return "device_lost";
    case ErrorCode::Protocol:
        return "protocol";
    case ErrorCode::DeviceRefused:
        return "device_refused";
    case ErrorCode::SafetyStop:
        return "safety_stop";
    case ErrorCode::ConsentMissing:
        return "consent_missing";
    case ErrorCode::Interrupted:
        return "interrupted";
    case ErrorCode::Terminated:
        return "terminated";
    case ErrorCode::Internal:
        return "internal";
    }
    return "internal";
}

} // namespace halbench
