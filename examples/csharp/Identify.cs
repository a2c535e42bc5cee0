// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// taut from C#: a net, a survey of it, its lengths and the turns that bring it to its form.
using System;
using System.Runtime.InteropServices;

static class Taut {
    const string Library = "taut_c";
    [DllImport(Library)] static extern IntPtr taut_error();
    [DllImport(Library)] public static extern IntPtr taut_builtin_net(string name);
    [DllImport(Library)] public static extern int taut_node_count(IntPtr net);
    [DllImport(Library)] public static extern int taut_edge_count(IntPtr net);
    [DllImport(Library)] public static extern int taut_equilibrium(IntPtr net, double[] lengths, double[] form, double[] tensions);
    [DllImport(Library)] public static extern IntPtr taut_make_survey(IntPtr net, double[] form, double noise);
    [DllImport(Library)] public static extern IntPtr taut_identify(IntPtr net, IntPtr survey, string options);
    [DllImport(Library)] static extern IntPtr taut_verdict(IntPtr result);
    [DllImport(Library)] public static extern IntPtr taut_plan_turns(IntPtr result, double[] target, string options);
    [DllImport(Library)] public static extern int taut_plan_strokes(IntPtr plan, double[] strokes);
    [DllImport(Library)] public static extern void taut_free_net(IntPtr net);
    [DllImport(Library)] public static extern void taut_free_survey(IntPtr survey);
    [DllImport(Library)] public static extern void taut_free_result(IntPtr result);
    [DllImport(Library)] public static extern void taut_free_plan(IntPtr plan);

    static string Text(IntPtr text) { return Marshal.PtrToStringAnsi(text); }
    public static string Verdict(IntPtr result) { return Text(taut_verdict(result)); }
    public static IntPtr Made(IntPtr handle) {
        if (handle == IntPtr.Zero) {
            throw new InvalidOperationException(Text(taut_error()));
        }
        return handle;
    }
}

static class Identify {
    static void Main() {
        IntPtr net = Taut.Made(Taut.taut_builtin_net("hypar:5x5"));
        var form = new double[3 * Taut.taut_node_count(net)];
        Taut.taut_equilibrium(net, null, form, null);
        var random = new Random(1);
        for (int i = 0; i < form.Length; ++i) {
            form[i] += 1e-3 * (random.NextDouble() - 0.5);
        }
        IntPtr survey = Taut.Made(Taut.taut_make_survey(net, form, 0.3e-3));
        IntPtr result = Taut.Made(Taut.taut_identify(net, survey, "{\"prior\": \"normal:1mm\"}"));
        Console.WriteLine("checks: " + Taut.Verdict(result));
        IntPtr plan = Taut.Made(Taut.taut_plan_turns(result, null, "{\"stroke\": \"5mm\"}"));
        var strokes = new double[Taut.taut_edge_count(net)];
        Taut.taut_plan_strokes(plan, strokes);
        for (int edge = 0; edge < strokes.Length; ++edge) {
            if (strokes[edge] != 0.0) {
                Console.WriteLine("edge {0}: {1:+0.00;-0.00} mm", edge, 1e3 * strokes[edge]);
            }
        }
        try {
            Taut.Made(Taut.taut_builtin_net("roof"));
        } catch (InvalidOperationException error) {
            Console.WriteLine("refused: " + error.Message);
        }
        Taut.taut_free_plan(plan);
        Taut.taut_free_result(result);
        Taut.taut_free_survey(survey);
        Taut.taut_free_net(net);
    }
}
