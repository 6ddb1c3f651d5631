#include "engines/worker/request.hpp"

#include <concepts>
#include <tuple>
#include <type_traits>

#include "engines/worker/message.hpp"

namespace rockstack {
namespace {

/// Begins every message: "rockstk" and the version of the form.
constexpr std::int64_t mark = 0x726f636b73746b05;

}  // namespace

template <class Given, class Wanted>
concept Is = std::same_as<std::remove_const_t<Given>, Wanted>;

auto fields(Is<Block> auto& block) {
  return std::tie(block.half_width, block.half_height, block.mass, block.inertia, block.offset_x,
                  block.offset_y);
}

auto fields(Is<Pulse> auto& pulse) {
  return std::tie(pulse.shape, pulse.amplitude, pulse.period, pulse.start, pulse.cycles, pulse.phase);
}

auto fields(Is<GroundMotion> auto& motion) {
  return std::tie(motion.interval, motion.samples, motion.source, motion.made_up, motion.pulse);
}

auto fields(Is<InitialState> auto& state) {
  return std::tie(state.angles, state.velocities, state.slip_velocities);
}

auto fields(Is<EngineSurface> auto& surface) {
  return std::tie(surface.friction, surface.depth);
}

auto fields(Is<Scene> auto& scene) {
  return std::tie(scene.title, scene.duration, scene.gravity, scene.inclination, scene.law, scene.equations,
                  scene.restitution, scene.blocks, scene.initial, scene.horizontal, scene.vertical,
                  scene.friction, scene.engine);
}

auto fields(Is<Setting> auto& setting) {
  return std::tie(setting.name, setting.standard, setting.tuned, setting.least, setting.most, setting.whole,
                  setting.choices);
}

auto fields(Is<EngineDescription> auto& engine) {
  return std::tie(engine.name, engine.solver, engine.version, engine.largest_friction, engine.settings);
}

auto fields(Is<RunRequest> auto& run) {
  return std::tie(run.solver, run.scene, run.dt, run.parameters, run.repeats, run.bodies);
}

/// Engines fill in samples alone.
auto fields(Is<History> auto& history) {
  return std::tie(history.blocks, history.times, history.angles, history.velocities, history.slips,
                  history.gaps, history.places);
}

auto fields(Is<ContactImpact> auto& impact) {
  return std::tie(impact.time, impact.interface, impact.speed, impact.after);
}

auto fields(Is<BodyRecord> auto& record) {
  return std::tie(record.energy, record.input, record.penetration, record.elastic, record.complementarity,
                  record.friction_excess, record.impacts, record.gap, record.slip, record.out_of_plane,
                  record.out_of_plane_tilt);
}

auto fields(Is<RunReply> auto& run) {
  return std::tie(run.status, run.reason, run.history, run.warnings, run.seconds, run.peak_memory,
                  run.bodies);
}

auto fields(Is<Request> auto& request) {
  return std::tie(request.run);
}

auto fields(Is<Reply> auto& reply) {
  return std::tie(reply.engines, reply.run);
}

namespace {

std::string bytes_of(const auto& message) {
  MessageWriter write;
  write(mark, message);
  return write.bytes();
}

template <class Message>
Message read_message(std::string_view bytes) {
  MessageReader read(bytes);
  std::int64_t found = 0;
  Message message;
  read(found);
  if (found != mark) throw std::runtime_error("the message is of another version of the program");
  read(message);
  return message;
}

}  // namespace

std::string to_bytes(const Request& request) {
  return bytes_of(request);
}

std::string to_bytes(const Reply& reply) {
  return bytes_of(reply);
}

Request read_request(std::string_view bytes) {
  return read_message<Request>(bytes);
}

Reply read_reply(std::string_view bytes) {
  return read_message<Reply>(bytes);
}

}  // namespace rockstack
