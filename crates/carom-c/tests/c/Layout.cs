// Prints size and offsets of every struct of Carom.cs, as the run time lays them out.
using System;
using System.Reflection;
using System.Runtime.InteropServices;

public static class Layout
{
    public static void Main(string[] names)
    {
        foreach (string name in names)
        {
            Type type = typeof(Carom).Assembly.GetType(name);
            Console.WriteLine("{0} {1}", name, Marshal.SizeOf(type));
            foreach (FieldInfo field in type.GetFields(BindingFlags.Public | BindingFlags.Instance))
            {
                Console.WriteLine("{0}.{1} {2}", name, field.Name, Marshal.OffsetOf(type, field.Name));
            }
        }
    }
}
