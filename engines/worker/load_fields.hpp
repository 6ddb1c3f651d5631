#pragma once

#include "engines/setup.hpp"
#include "engines/worker/message.hpp"

namespace rockstack {

/// Adds the fields of pushes and restraints to a run's, where a setup has some.
void write_loads(const Setup& setup, Form form, nlohmann::json& object);

/// Reads them into a setup, whose blocks are known. @throws WrongField
void read_loads(const nlohmann::json& object, Setup& setup);

}  // namespace rockstack
