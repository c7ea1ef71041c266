#pragma once

#include "app/documents/result_header.h"
#include "app/procedures/identify/identify_procedure.h"

#include <string>

namespace halbench::app {

/// MODEL.json with everything it shows: intervals, points, findings, provenance. The recording of the
/// excitation is not part of it.
struct IdentificationFile {
    ResultHeader header;
    IdentifyResult result;
};

/// Errors: as of readModelFile().
Result<IdentificationFile> readIdentificationFile(const std::string& path);
/// The same from text; `origin` names it in messages.
Result<IdentificationFile> parseIdentification(const std::string& text, const std::string& origin);

} // namespace halbench::app
