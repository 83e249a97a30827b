// Ten thousand projectiles, read in bulk into an engine's own structs: `./dev csharp` runs it under Mono. It says what
// fails and ends with 1.
using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Runtime.InteropServices;
using PhySim;

/// An object of an engine, as it might draw one.
struct Sprite {
  public float x, y, z;
  public uint colour;
  public physim_id id;
}

static unsafe class Test {
  const int Count = 10000;
  static int failures;

  static void Check(bool good, string what) {
    if (good) return;
    Console.WriteLine("wrong: " + what + " [" + Marshal.PtrToStringAnsi(C.physim_last_error()) + "]");
    ++failures;
  }
  static void Ok(physim_result code, string what) { Check(code == physim_result.PHYSIM_OK, what); }
  static void Lift(IntPtr user, physim_force_batch* batch) {
    ++*(int*)user;
    var force = batch->force;
    for (ulong i = 0; i < (ulong)batch->count; ++i) force[3 * i + 1] = 9.80665 * batch->mass[i];
  }

  /// Where members of structs lie, as a program of C prints it (tools/c_interface.py layouts).
  static void PrintLayouts() {
    var types = new List<Type>(Array.FindAll(typeof(C).Assembly.GetTypes(), IsOfInterface));
    types.Sort((a, b) => String.CompareOrdinal(a.Name, b.Name));
    foreach (var type in types) {
      Console.WriteLine("{0} {1}", type.Name, Marshal.SizeOf(type));
      foreach (var member in type.GetFields())
        Console.WriteLine("{0}.{1} {2}", type.Name, member.Name, Marshal.OffsetOf(type, member.Name));
    }
  }
  static bool IsOfInterface(Type type) {
    return type.Namespace == "PhySim" && type.IsValueType && !type.IsEnum && !type.IsNested;
  }

  static int begun, lines;
  static void Begin(IntPtr user, physim_id projectile) { ++begun; }
  static void Line(IntPtr user, double* a, double* b, int ink) {
    if (ink == (int)physim_ink.PHYSIM_INK_VELOCITY && b[0] > a[0]) ++lines;
  }
  static void Draw(IntPtr world) {
    physim_canvas_begin begin = Begin;
    physim_canvas_line line = Line;
    var canvas = new physim_canvas { size = (uint)sizeof(physim_canvas) };
    canvas.begin = Marshal.GetFunctionPointerForDelegate(begin);
    canvas.line = Marshal.GetFunctionPointerForDelegate(line);
    var what = new physim_drawing { size = (uint)sizeof(physim_drawing), layers = ~0u, ahead = 0.1 };
    Ok(C.physim_world_draw(world, &what, &canvas), "drawing");
    Check(begun == Count && lines == Count, "each projectile is drawn with its velocity");
    GC.KeepAlive(begin);
    GC.KeepAlive(line);
  }

  static void Main(string[] arguments) {
    if (arguments.Length == 1 && arguments[0] == "layouts") {
      PrintLayouts();
      return;
    }
    IntPtr def, world, flight;
    Ok(C.physim_def_create(null, null, out def), "a def");
    foreach (var setting in new[] { "mass=1 kg", "diameter=10 cm", "fidelity=game", "speed=20 m/s", "elevation=45 deg",
                                    "body.gravity_scale=1", "world.step=10 ms" }) {
      var parts = setting.Split('=');
      Ok(C.physim_set(def, parts[0], parts[1]), setting);
    }
    Check(C.physim_set(def, "shot.mas", "1 kg") == physim_result.PHYSIM_REFUSED, "a setting that is none");
    Check(Marshal.PtrToStringAnsi(C.physim_last_hint()).Contains("shot.mass"), "the hint of the error");

    // One flight: without drag and on even ground it would land at v^2 / g; drag takes some of it.
    Ok(C.physim_fly(def, null, null, out flight), "a flight");
    var end = new physim_sample { size = (uint)sizeof(physim_sample) };
    Ok(C.physim_flight_at(flight, physim_moment.PHYSIM_AT_END, 0, &end), "its end");
    Check(end.position[0] > 35 && end.position[0] < 20 * 20 / 9.80665, "where it lands");

    Ok(C.physim_world_create(def, physim_firing.PHYSIM_FIRE_NOTHING, out world), "a world");
    uint kind;
    Ok(C.physim_world_add_kind(world, def, null, 0, 0, &kind), "a kind");
    var speeds = new double[Count];
    for (int i = 0; i < Count; ++i) speeds[i] = 10 + 0.001 * i;
    UIntPtr spawned;
    fixed (double* speed = speeds) {
      var launches = new physim_launches { size = (uint)sizeof(physim_launches), speed = speed };
      Ok(C.physim_world_spawn(world, kind, (UIntPtr)Count, &launches, null, &spawned), "spawning");
    }
    Check((int)spawned == Count, "all are spawned");
    ReadInBulk(world);
    Draw(world);

    // A force in C#: with it they fly straight on.
    int calls = 0;
    physim_force_function lift = Lift;
    physim_id force;
    Ok(C.physim_world_add_force_function(world, lift, (IntPtr)(&calls), null, UIntPtr.Zero, ~0u, &force), "a force");
    Ok(C.physim_world_step(world, 10, 0), "steps with a force");
    Check(calls >= 10, "the force is asked");
    GC.KeepAlive(lift);
    ulong hash;
    Ok(C.physim_world_hash(world, &hash), "a hash");
    Ok(C.physim_free(world), "freeing");
    Check(C.physim_free(world) == physim_result.PHYSIM_BAD_HANDLE, "freeing twice");
    Ok(C.physim_free(flight), "freeing");
    Ok(C.physim_free(def), "freeing");
    if (failures == 0) Console.WriteLine("PhySim from C#: all as it must be, hash {0:x16}", hash);
    Environment.Exit(failures == 0 ? 0 : 1);
  }

  static void ReadInBulk(IntPtr world) {
    const int Frames = 100;
    var sprites = new Sprite[Count];
    var watch = new Stopwatch();
    UIntPtr read = UIntPtr.Zero;
    int collections = 0;
    long memory = 0;
    fixed (Sprite* first = sprites) {
      var into = new physim_states { size = (uint)sizeof(physim_states), stride = (UIntPtr)sizeof(Sprite) };
      into.position_f = &first->x;
      into.id = &first->id;
      for (int frame = 0; frame < Frames; ++frame) {
        Ok(C.physim_world_step(world, 1, 0), "a step");
        if (frame == 10) {
          collections = GC.CollectionCount(0);
          memory = GC.GetTotalMemory(false);
        }
        watch.Start();
        var code = C.physim_world_states(world, null, (UIntPtr)Count, &into, &read);
        watch.Stop();
        Ok(code, "a read");
      }
    }
    Check(GC.CollectionCount(0) == collections && GC.GetTotalMemory(false) <= memory, "reading allocates nothing");
    Check((int)read == Count, "all are read");
    double far = 0;
    foreach (var sprite in sprites) far = Math.Max(far, sprite.x);
    Check(far > 13 && far < 20 * Math.Sqrt(0.5), "they have flown for a second");
    physim_projectile one = new physim_projectile { size = (uint)sizeof(physim_projectile) };
    Ok(C.physim_world_projectile(world, sprites[77].id, &one), "one of them");
    Check((float)one.position[0] == sprites[77].x, "it is where the bulk says");
    Console.WriteLine("{0} projectiles are read in {1:f1} us", Count, 1e6 * watch.Elapsed.TotalSeconds / Frames);
  }
}
