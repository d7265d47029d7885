// Plays a break frame by frame at 60 Hz, as a game in Unity or Godot does. Program for a test too.
//
//     mcs -unsafe -out:frames.exe Frames.cs ../../crates/carom-c/include/Carom.cs && mono frames.exe

using System;
using System.Text;

public static class Frames
{
    private const double Step = 1.0 / 60.0; // s

    private static IntPtr Checked(IntPtr made, byte[] error)
    {
        if (made == IntPtr.Zero)
        {
            throw new InvalidOperationException(Encoding.UTF8.GetString(error).TrimEnd('\0'));
        }
        return made;
    }

    public static unsafe int Main()
    {
        if (Carom.carom_version() / 100 != Carom.CAROM_VERSION / 100)
        {
            Console.Error.WriteLine("the library has another version than Carom.cs");
            return 1;
        }
        byte[] error = new byte[512];
        carom_break_def opening = Carom.carom_default_break_def();
        opening.seed = 20;
        IntPtr shot = Checked(Carom.carom_break_shot(new[] { opening }, error, error.Length), error);
        IntPtr trace = Checked(Carom.carom_shot_simulate(shot, error, error.Length), error);
        carom_state[] states = new carom_state[Carom.carom_shot_ball_count(shot)];
        carom_events[] found = new carom_events[1];
        Carom.carom_trace_events(trace, found);
        carom_event* events = (carom_event*)found[0].events;
        int sound = 0;
        double duration = Carom.carom_trace_duration(trace);
        double turned = 0.0;
        int frames = 0;
        for (double time = 0.0; time <= duration; time = ++frames * Step)
        {
            for (; sound < found[0].event_count && events[sound].time <= time; ++sound)
            {
                // A game plays a sample here, as loud as events[sound].strength (N s).
            }
            if (Carom.carom_trace_states(trace, time, states, states.Length) != 0)
            {
                return 1;
            }
            fixed (carom_state* state = &states[0])
            {
                // A game sets the transform of its ball here: new Quaternion(x, y, z, w).
                turned = state->orientation[3];
            }
        }
        Console.WriteLine("{0} frames, {1} events, w = {2:R}, hash {3:x16}", frames, sound, turned,
                          Carom.carom_trace_hash(trace));
        Carom.carom_trace_free(trace);
        Carom.carom_shot_free(shot);
        return 0;
    }
}
