// carom for C#, by P/Invoke: Unity, Godot and .NET. carom.h has the documentation of each function, and
// docs/game.md the guide. Written by `make reference` from carom.h; do not edit. Compile with -unsafe.
//
// Structs are blittable. A pointer is an IntPtr; Carom.Text reads a text that the library owns, and
// Carom.Taken one that it gives away.

using System;
using System.Runtime.InteropServices;
using System.Text;

[StructLayout(LayoutKind.Sequential)]
public unsafe struct carom_strike
{
    public double speed;
    public double azimuth;
    public double elevation;
    public double side;
    public double height;
    public int has_elevation;
    public int policy;
}

[StructLayout(LayoutKind.Sequential)]
public unsafe struct carom_frame_def
{
    public IntPtr game;
    public IntPtr table;
    public IntPtr physics;
    public ulong seed;
    public int points;
    public int no_miss;
    public uint patience;
}

[StructLayout(LayoutKind.Sequential)]
public unsafe struct carom_request
{
    public int kind;
    public int player;
    public int winner;
    public int cue_ball;
    public int in_hand;
    public int calls;
    public int on_count;
    public fixed int on[22];
    public int choice_count;
    public fixed int choices[10];
}

[StructLayout(LayoutKind.Sequential)]
public unsafe struct carom_play
{
    public carom_strike strike;
    public fixed double cue_ball[2];
    public int has_cue_ball;
    public int call;
    public int call_ball;
    public int call_pocket;
}

[StructLayout(LayoutKind.Sequential)]
public unsafe struct carom_ruling
{
    public int legal;
    public int foul_count;
    public fixed int points[2];
    public int spotted_count;
    public int racked;
}

[StructLayout(LayoutKind.Sequential)]
public unsafe struct carom_think_def
{
    public IntPtr noise;
    public IntPtr opponent_noise;
    public IntPtr stop;
    public double time;
    public ulong seed;
    public ulong simulations;
    public uint rounds;
    public int threads;
}

[StructLayout(LayoutKind.Sequential)]
public unsafe struct carom_decision
{
    public carom_play play;
    public double win_chance;
    public ulong simulations;
    public uint rounds;
    public int kind;
    public int choice;
    public int stopped;
}

[StructLayout(LayoutKind.Sequential)]
public unsafe struct carom_ball
{
    public IntPtr id;
    public fixed double position[3];
    public fixed double velocity[3];
    public fixed double angular_velocity[3];
    public double mass;
    public double radius;
}

[StructLayout(LayoutKind.Sequential)]
public unsafe struct carom_shot_def
{
    public IntPtr balls;
    public int ball_count;
    public int struck;
    public carom_strike strike;
    public double until;
    public uint max_events;
}

[StructLayout(LayoutKind.Sequential)]
public unsafe struct carom_break_def
{
    public IntPtr game;
    public IntPtr table;
    public IntPtr preset;
    public double speed;
    public ulong seed;
}

[StructLayout(LayoutKind.Sequential)]
public unsafe struct carom_table_def
{
    public IntPtr table;
    public IntPtr physics;
}

[StructLayout(LayoutKind.Sequential)]
public unsafe struct carom_table_size
{
    public double width;
    public double length;
    public double cushion_height;
    public double ball_radius;
    public double ball_mass;
    public int pocket_count;
}

[StructLayout(LayoutKind.Sequential)]
public unsafe struct carom_pocket
{
    public fixed double center[2];
    public double radius;
}

[StructLayout(LayoutKind.Sequential)]
public unsafe struct carom_state
{
    public fixed double position[3];
    public fixed double velocity[3];
    public fixed double angular_velocity[3];
    public fixed double orientation[4];
    public int motion;
}

[StructLayout(LayoutKind.Sequential)]
public unsafe struct carom_event
{
    public double time;
    public double strength;
    public int kind;
    public int first_ball;
    public int ball_count;
    public int first_point;
    public int point_count;
    public int rail;
    public int part;
    public int pocket;
    public int from;
    public int to;
    public int tip_contacts;
    public int pushed;
}

[StructLayout(LayoutKind.Sequential)]
public unsafe struct carom_motion
{
    public fixed double position[3];
    public fixed double velocity[3];
    public fixed double angular_velocity[3];
    public int motion;
}

[StructLayout(LayoutKind.Sequential)]
public unsafe struct carom_event_ball
{
    public fixed double impulse[3];
    public carom_motion before;
    public carom_motion after;
    public int ball;
}

[StructLayout(LayoutKind.Sequential)]
public unsafe struct carom_events
{
    public IntPtr events;
    public IntPtr balls;
    public IntPtr points;
    public int event_count;
    public int ball_count;
    public int point_count;
}

public static class Carom
{
    public const string Library = "carom";

    public const int CAROM_ON_TABLE = -1;
    public const int CAROM_LEFT = -2;
    public const int CAROM_PADDING = -3;
    public const int CAROM_REFUSED = -1;
    public const int CAROM_EVENT_CAP = -2;
    public const int CAROM_FAULT = -3;
    public const int CAROM_ASKS_SHOT = 0;
    public const int CAROM_ASKS_CHOICE = 1;
    public const int CAROM_OVER = 2;
    public const int CAROM_ANYWHERE = 0;
    public const int CAROM_BEHIND_HEAD_STRING = 1;
    public const int CAROM_THE_D = 2;
    public const int CAROM_MAY_CALL = 1;
    public const int CAROM_MAY_CALL_SAFETY = 2;
    public const int CAROM_MUST_CALL = 4;
    public const int CAROM_MAY_PUSH_OUT = 8;
    public const int CAROM_MUST_NOMINATE = 16;
    public const int CAROM_PLAY_ON = 0;
    public const int CAROM_PLAY_FROM_HAND = 1;
    public const int CAROM_PASS_BACK = 2;
    public const int CAROM_REBREAK = 3;
    public const int CAROM_REBREAK_BY_OTHER = 4;
    public const int CAROM_SPOT_EIGHT = 5;
    public const int CAROM_REPLACE = 6;
    public const int CAROM_SPOT_FROZEN = 7;
    public const int CAROM_SPOT_NEAREST = 8;
    public const int CAROM_PLAY_FROM_ANYWHERE = 9;
    public const int CAROM_NONE = -1;
    public const int CAROM_STATIONARY = 0;
    public const int CAROM_SPINNING = 1;
    public const int CAROM_ROLLING = 2;
    public const int CAROM_SLIDING = 3;
    public const int CAROM_AIRBORNE = 4;
    public const int CAROM_POCKETED = 5;
    public const int CAROM_OFF_TABLE = 6;
    public const int CAROM_CUE_STRIKE = 0;
    public const int CAROM_BALL_COLLISION = 1;
    public const int CAROM_RAIL_COLLISION = 2;
    public const int CAROM_POCKET_COLLISION = 3;
    public const int CAROM_SLATE_COLLISION = 4;
    public const int CAROM_LEFT_TABLE = 5;
    public const int CAROM_MOTION_TRANSITION = 6;
    public const int CAROM_BOTTOM = 0;
    public const int CAROM_TOP = 1;
    public const int CAROM_RIGHT = 3;
    public const int CAROM_LEFT_LOWER = 4;
    public const int CAROM_LEFT_UPPER = 5;
    public const int CAROM_RIGHT_LOWER = 6;
    public const int CAROM_RIGHT_UPPER = 7;
    public const int CAROM_NOSE = 0;
    public const int CAROM_FACING = 1;
    public const int CAROM_POINT = 2;
    public const int CAROM_RAIL_TOP = 3;
    public const int CAROM_LINER = 4;
    public const int CAROM_END_REST = 0;
    public const int CAROM_END_UNTIL = 1;
    public const int CAROM_END_CAP = 2;
    public const int CAROM_CALL_NOTHING = 0;
    public const int CAROM_CALL_POCKET = 1;
    public const int CAROM_CALL_SAFETY = 2;
    public const int CAROM_CALL_PUSH_OUT = 3;
    public const int CAROM_CALL_ON = 4;
    public const int CAROM_DECIDES_PLAY = 0;
    public const int CAROM_DECIDES_CHOICE = 1;
    public const int CAROM_DECIDES_CONCEDE = 2;
    public const int CAROM_REFUSE_OBSTRUCTION = 1;
    public const int CAROM_REPORT_MISCUE = 2;
    public const int CAROM_VERSION = 100;

    /// <summary>The bytes of a text for a pointer argument, with a final zero.</summary>
    public static byte[] Bytes(string text)
    {
        return Encoding.UTF8.GetBytes(text + "\0");
    }

    /// <summary>A text that stays with the library, or the text of an error.</summary>
    public static string Text(IntPtr text)
    {
        int length = 0;
        while (text != IntPtr.Zero && Marshal.ReadByte(text, length) != 0)
        {
            ++length;
        }
        byte[] bytes = new byte[length];
        if (length > 0)
        {
            Marshal.Copy(text, bytes, 0, length);
        }
        return Encoding.UTF8.GetString(bytes);
    }

    /// <summary>A text that the library gives away; it is freed.</summary>
    public static string Taken(IntPtr text)
    {
        string taken = Text(text);
        carom_text_free(text);
        return taken;
    }

    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern int carom_batch([In, Out] IntPtr[] shots, UIntPtr n, int balls, int threads, [In, Out] double[] position, [In, Out] sbyte[] pocket, [In, Out] int[] events, [In, Out] byte[] error, int error_size);

    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern int carom_batch_strikes(IntPtr shot, [In, Out] carom_strike[] strikes, UIntPtr n, int balls, int threads, [In, Out] double[] position, [In, Out] sbyte[] pocket, [In, Out] int[] events, [In, Out] byte[] error, int error_size);

    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern carom_frame_def carom_default_frame_def();

    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern IntPtr carom_frame_new([In, Out] carom_frame_def[] def, [In, Out] byte[] error, int error_size);

    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern IntPtr carom_frame_of_shot([In, Out] carom_frame_def[] def, IntPtr shot, [In, Out] byte[] error, int error_size);

    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern IntPtr carom_frame_from_json([In, Out] byte[] json, [In, Out] byte[] error, int error_size);

    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern IntPtr carom_frame_to_json(IntPtr frame);

    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern IntPtr carom_frame_last_move_json(IntPtr frame);

    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern IntPtr carom_frame_copy(IntPtr frame);

    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern ulong carom_frame_hash(IntPtr frame);

    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern IntPtr carom_frame_state_json(IntPtr frame);

    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern IntPtr carom_frame_ruling_json(IntPtr frame);

    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern int carom_frame_request(IntPtr frame, [In, Out] carom_request[] @out);

    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern int carom_frame_ball_count(IntPtr frame);

    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern IntPtr carom_frame_ball_id(IntPtr frame, int ball);

    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern int carom_frame_ball_place(IntPtr frame, int ball, [In, Out] double[] @out);

    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern IntPtr carom_frame_shot(IntPtr frame, [In, Out] carom_play[] play, [In, Out] byte[] error, int error_size);

    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern int carom_frame_play(IntPtr frame, [In, Out] carom_play[] play, [In, Out] carom_ruling[] ruling, [In, Out] IntPtr[] trace, [In, Out] byte[] error, int error_size);

    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern int carom_frame_move(IntPtr frame, [In, Out] byte[] json, [In, Out] carom_ruling[] ruling, [In, Out] IntPtr[] trace, [In, Out] byte[] error, int error_size);

    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern int carom_frame_choose(IntPtr frame, int choice, [In, Out] carom_ruling[] ruling, [In, Out] byte[] error, int error_size);

    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern int carom_frame_concede(IntPtr frame, [In, Out] carom_ruling[] ruling, [In, Out] byte[] error, int error_size);

    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern IntPtr carom_frame_why(IntPtr frame);

    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern void carom_frame_free(IntPtr frame);

    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern carom_play carom_default_play_def();

    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern carom_think_def carom_default_think_def();

    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern IntPtr carom_player_new([In, Out] byte[] name, [In, Out] byte[] error, int error_size);

    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern int carom_player_decide(IntPtr player, IntPtr frame, [In, Out] carom_think_def[] def, [In, Out] carom_decision[] @out, [In, Out] byte[] error, int error_size);

    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern int carom_frame_draw(IntPtr frame, [In, Out] carom_play[] play, [In, Out] byte[] noise, ulong seed, [In, Out] carom_play[] @out, [In, Out] byte[] error, int error_size);

    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern IntPtr carom_stop_new();

    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern void carom_stop_set(IntPtr stop, int set);

    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern void carom_stop_free(IntPtr stop);

    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern void carom_player_free(IntPtr player);

    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern carom_strike carom_default_strike_def();

    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern carom_shot_def carom_default_shot_def();

    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern carom_break_def carom_default_break_def();

    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern IntPtr carom_shot_new(IntPtr table, [In, Out] carom_shot_def[] def, [In, Out] byte[] error, int error_size);

    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern IntPtr carom_shot_from_json([In, Out] byte[] json, [In, Out] byte[] error, int error_size);

    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern IntPtr carom_break_shot([In, Out] carom_break_def[] def, [In, Out] byte[] error, int error_size);

    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern IntPtr carom_shot_with_strike(IntPtr shot, [In, Out] carom_strike[] strike, [In, Out] byte[] error, int error_size);

    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern IntPtr carom_shot_to_json(IntPtr shot);

    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern IntPtr carom_shot_table(IntPtr shot);

    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern int carom_shot_ball_count(IntPtr shot);

    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern int carom_shot_ball(IntPtr shot, int ball, [In, Out] carom_ball[] @out);

    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern int carom_shot_ball_index(IntPtr shot, [In, Out] byte[] id);

    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern int carom_shot_strike(IntPtr shot, [In, Out] carom_strike[] @out);

    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern void carom_shot_free(IntPtr shot);

    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern IntPtr carom_error_kinds_json();

    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern IntPtr carom_sim_new();

    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern IntPtr carom_sim_play(IntPtr sim, IntPtr shot, [In, Out] byte[] error, int error_size);

    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern void carom_sim_free(IntPtr sim);

    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern carom_table_def carom_default_table_def();

    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern IntPtr carom_table_new([In, Out] carom_table_def[] def, [In, Out] byte[] error, int error_size);

    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern void carom_table_free(IntPtr table);

    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern int carom_table_get_size(IntPtr table, [In, Out] carom_table_size[] @out);

    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern int carom_table_get_pocket(IntPtr table, int pocket, [In, Out] carom_pocket[] @out);

    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern IntPtr carom_table_geometry_json(IntPtr table);

    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern IntPtr carom_table_physics_json(IntPtr table);

    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern void carom_text_free(IntPtr text);

    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern IntPtr carom_presets_json();

    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern IntPtr carom_shot_simulate(IntPtr shot, [In, Out] byte[] error, int error_size);

    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern int carom_trace_state(IntPtr trace, int ball, double time, [In, Out] carom_state[] @out);

    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern int carom_trace_states(IntPtr trace, double time, [In, Out] carom_state[] @out, int count);

    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern int carom_trace_events(IntPtr trace, [In, Out] carom_events[] @out);

    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern int carom_trace_path(IntPtr trace, int ball, double tolerance, [In, Out] double[] @out, int count);

    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern double carom_trace_duration(IntPtr trace);

    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern int carom_trace_end(IntPtr trace);

    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern ulong carom_trace_hash(IntPtr trace);

    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern IntPtr carom_trace_outcome_json(IntPtr trace);

    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern IntPtr carom_trace_to_json(IntPtr trace);

    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern IntPtr carom_trace_from_json([In, Out] byte[] json, [In, Out] byte[] error, int error_size);

    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern IntPtr carom_trace_shot(IntPtr trace);

    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern void carom_trace_free(IntPtr trace);

    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern int carom_version();

    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern IntPtr carom_engine();
}
