#pragma once

#include <span>

namespace halbench::widgets {

/// Tables of the phrasebook: English texts as the sources have them, {} for what is filled in, marked for the
/// translator in the context "Phrases". All but the last two are written by tests/architecture/phrases.py.
std::span<const char* const> phrasesOfControl();
std::span<const char* const> phrasesOfLines();
std::span<const char* const> phrasesOfDevices();
std::span<const char* const> phrasesOfReferences();
std::span<const char* const> phrasesOfProcedures();
std::span<const char* const> phrasesOfTuning();
std::span<const char* const> phrasesOfActuators();
std::span<const char* const> phrasesOfFiles();
std::span<const char* const> phrasesOfBoards();
std::span<const char* const> phrasesOfSimulation();

} // namespace halbench::widgets
