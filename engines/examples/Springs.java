// A worker in Java, as an example of engines/README.md: springs, dashpots and sliders at the corners of blocks,
// stepped by semi-implicit Euler in 64 parts of each step. Nothing but the JDK is needed: `javac -d classes
// Springs.java`, and as the worker a program with the lines `#!/bin/sh` and `exec java -cp classes Springs`.

import java.io.FileOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

public final class Springs {
  private static final int PARTS = 64;  // of a step

  /** Steps until the compiler of the virtual machine has seen all of them often enough. */
  private static final int WARM_UP = 2000;

  private static final String ENGINE = """
      {"name": "java-springs", "solver": "euler", "version": "1", "licence": "same as rockstack", "planar": true,
       "lead": %s, "warm_up": %d, "settings": [
         {"name": "sinking", "default": 1e-4, "tuned": 1e-6, "least": 1e-9, "most": 1, "unit": "m"},
         {"name": "dampingRatio", "default": 0.5, "tuned": 2, "least": 0, "most": 10}]}""".formatted(
      0.5 / PARTS, WARM_UP);

  /** A value of JSON: Map, List, String, Double, Boolean or null. */
  private static final class Json {
    private final String text;
    private int at = 0;

    Json(String text) {
      this.text = text;
    }

    private char next() {
      while (Character.isWhitespace(text.charAt(at))) ++at;
      return text.charAt(at);
    }

    private boolean take(char letter) {
      if (next() != letter) return false;
      ++at;
      return true;
    }

    Object value() {
      if (take('{')) {
        Map<String, Object> map = new HashMap<>();
        while (!take('}')) {
          String key = (String) value();
          take(':');
          map.put(key, value());
          take(',');
        }
        return map;
      }
      if (take('[')) {
        List<Object> list = new ArrayList<>();
        while (!take(']')) {
          list.add(value());
          take(',');
        }
        return list;
      }
      int start = at;
      if (take('"')) {
        at = text.indexOf('"', at) + 1;  // no text of a question has a quote in it
        return text.substring(start + 1, at - 1);
      }
      while (",]} \n".indexOf(text.charAt(at)) < 0) ++at;
      String word = text.substring(start, at);
      return switch (word) {
        case "true", "false" -> Boolean.valueOf(word);
        case "null" -> null;
        default -> Double.valueOf(word);
      };
    }
  }

  /** The part of a question that is an object. */
  private record Fields(Map<?, ?> map) {
    double number(String name) {
      return (Double) map.get(name);
    }

    Fields object(String name) {
      return new Fields((Map<?, ?>) map.get(name));
    }

    List<?> list(String name) {
      return (List<?>) map.get(name);
    }
  }

  /** Place and velocity along x and y, m and m/s, and clockwise about the centre, rad and rad/s. */
  private static final class Body {
    final double[] place, rate, force = new double[3], mass;
    final double halfWidth, halfHeight;

    Body(Fields block) {
      place = new double[] {block.number("x"), block.number("y"), block.number("angle")};
      rate = new double[] {
          block.number("velocity_x"), block.number("velocity_y"), block.number("angular_velocity")};
      mass = new double[] {block.number("mass"), block.number("mass"), block.number("inertia")};
      halfWidth = block.number("width") / 2;
      halfHeight = block.number("height") / 2;
    }

    /** The ground: y = 0, without end. */
    Body() {
      place = new double[3];
      rate = new double[3];
      mass = new double[3];
      halfWidth = Double.POSITIVE_INFINITY;
      halfHeight = 0;
    }

    double[] point(double x, double y) {
      double c = Math.cos(place[2]), s = Math.sin(place[2]);
      return new double[] {place[0] + x * c + y * s, place[1] - x * s + y * c};
    }

    double[] local(double[] point) {
      double c = Math.cos(place[2]), s = Math.sin(place[2]), x = point[0] - place[0], y = point[1] - place[1];
      return new double[] {x * c - y * s, x * s + y * c};
    }

    double[] velocity(double[] point) {
      return new double[] {
          rate[0] + rate[2] * (point[1] - place[1]), rate[1] - rate[2] * (point[0] - place[0])};
    }

    void push(double[] point, double along, double up) {
      force[0] += along;
      force[1] += up;
      force[2] += (point[1] - place[1]) * along - (point[0] - place[0]) * up;
    }

    void move(double time, double[] pull) {
      for (int axis = 0; axis < 3; ++axis) {
        rate[axis] += time * (pull[axis] + force[axis] / mass[axis]);
        place[axis] += time * rate[axis];
        force[axis] = 0;
      }
    }
  }

  private final Fields asked;
  private final List<Body> bodies = new ArrayList<>();  // the ground first
  private final double stiffness, damping;              // of each corner, N/m and N s/m

  private Springs(Fields asked) {
    this.asked = asked;
    bodies.add(new Body());
    double mass = 0;
    for (Object block : asked.list("blocks")) {
      bodies.add(new Body(new Fields((Map<?, ?>) block)));
      mass += bodies.get(bodies.size() - 1).mass[0];
    }
    // Two corners bear the stack on Earth at the depth that was asked for.
    Fields parameters = asked.object("parameters");
    stiffness = 9.81 * mass / (2 * parameters.number("sinking"));
    damping = 2 * parameters.number("dampingRatio") * Math.sqrt(stiffness * mass);
  }

  /** Corners of each body in the other's face. */
  private void touch(Body lower, Body upper, double friction) {
    for (int side = -1; side <= 1; side += 2) {
      double[] corner = upper.point(side * upper.halfWidth, -upper.halfHeight);
      double[] seen = lower.local(corner);
      if (Math.abs(seen[0]) <= lower.halfWidth)
        bear(lower, upper, corner, lower.place[2], lower.halfHeight - seen[1], friction);
      if (Double.isInfinite(lower.halfWidth)) continue;
      corner = lower.point(side * lower.halfWidth, lower.halfHeight);
      seen = upper.local(corner);
      if (Math.abs(seen[0]) <= upper.halfWidth)
        bear(lower, upper, corner, upper.place[2], upper.halfHeight + seen[1], friction);
    }
  }

  /** A point that is `depth` deep in a face at `angle`. */
  private void bear(Body lower, Body upper, double[] point, double angle, double depth, double friction) {
    if (depth <= 0) return;
    double[] low = lower.velocity(point), high = upper.velocity(point);
    double c = Math.cos(angle), s = Math.sin(angle);
    double up = (high[0] - low[0]) * s + (high[1] - low[1]) * c;
    double along = (high[0] - low[0]) * c - (high[1] - low[1]) * s;
    double normal = Math.max(0, stiffness * depth - damping * up);
    double tangential = Math.max(-friction * normal, Math.min(friction * normal, -damping * along));
    upper.push(point, normal * s + tangential * c, normal * c - tangential * s);
    lower.push(point, -normal * s - tangential * c, tangential * s - normal * c);
  }

  private void step(double[] pull) {
    List<?> friction = asked.list("friction");
    for (int part = 0; part < PARTS; ++part) {
      for (int k = 1; k < bodies.size(); ++k)
        touch(bodies.get(k - 1), bodies.get(k), (Double) friction.get(k - 1));
      for (int k = 1; k < bodies.size(); ++k) bodies.get(k).move(asked.number("dt") / PARTS, pull);
    }
  }

  private double[] pull(int step) {
    boolean shaken = asked.map().containsKey("accelerations");
    Fields pull = asked.object(shaken ? "accelerations" : "gravity");
    return shaken
        ? new double[] {(Double) pull.list("x").get(step), (Double) pull.list("y").get(step), 0}
        : new double[] {pull.number("x"), pull.number("y"), 0};
  }

  private boolean hasToppled() {
    List<?> angles = asked.list("toppling_angles");
    for (int k = 1; k < bodies.size(); ++k)
      if (Math.abs(bodies.get(k).place[2]) > (Double) angles.get(k - 1)) return true;
    return false;
  }

  /** All samples, the first at the start, one body's place and velocity after another. */
  private List<double[]> run() {
    List<double[]> samples = new ArrayList<>();
    for (int step = 0;; ++step) {
      for (Body body : bodies.subList(1, bodies.size()))
        samples.add(new double[] {
            body.place[0], body.place[1], body.place[2], body.rate[0], body.rate[1], body.rate[2]});
      if (step == asked.number("steps") || hasToppled()) return samples;
      step(pull(step));
    }
  }

  /** Wall time of so many steps, s. */
  private static double time(Fields asked, int steps) {
    Springs springs = new Springs(asked);
    long start = System.nanoTime();
    for (int step = 0; step < steps; ++step) springs.step(springs.pull(step));
    return 1e-9 * (System.nanoTime() - start);
  }

  private static String column(String name, List<double[]> samples, int axis) {
    return "\"" + name + "\": " + samples.stream().map(sample -> sample[axis]).toList();
  }

  private static String answer(Fields asked) {
    List<double[]> samples = new Springs(asked).run();
    int steps = samples.size() / asked.list("blocks").size() - 1, taken = steps;
    for (; asked.map().containsKey("warm_up") && taken < asked.number("warm_up"); taken += steps) time(asked, steps);
    List<Double> seconds = new ArrayList<>();
    for (int repeat = 0; repeat < asked.number("repeats"); ++repeat) seconds.add(time(asked, steps));
    String bodies = String.join(", ", column("x", samples, 0), column("y", samples, 1),
        column("velocity_x", samples, 3), column("velocity_y", samples, 4));
    return String.join(", ", "\"status\": \"done\"", column("angles", samples, 2),
        column("velocities", samples, 5), "\"seconds\": " + seconds, "\"warm_up\": " + taken,
        asked.map().get("bodies").equals(true) ? "\"bodies\": {" + bodies + "}" : "\"warnings\": 0");
  }

  public static void main(String[] arguments) throws IOException {
    String question = new String(System.in.readAllBytes(), StandardCharsets.UTF_8);
    Fields message = new Fields((Map<?, ?>) new Json(question).value());
    String reply = message.map().containsKey("run")
        ? "\"run\": {" + answer(message.object("run")) + "}"
        : "\"engines\": [" + ENGINE + "]";
    try (FileOutputStream stream = new FileOutputStream("/dev/fd/3")) {
      stream.write(("{\"rockstack\": 1, " + reply + "}").getBytes(StandardCharsets.UTF_8));
    }
  }
}
