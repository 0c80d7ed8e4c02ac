// Sets a signal of a running rigsoundd and follows what changes: ControlClient PORT TOKEN_FILE [KEY VALUE], with the rig's
// [control] tcp = "127.0.0.1:PORT" and token_file. Also from inside a program: nothing here needs more than .NET 4.5.
using System;
using System.IO;
using System.Net.Sockets;

public static class ControlClient
{
    public static void Main(string[] args)
    {
        using (var tcp = new TcpClient("127.0.0.1", int.Parse(args[0])))
        using (var stream = tcp.GetStream())
        using (var reader = new StreamReader(stream))
        using (var writer = new StreamWriter(stream) { NewLine = "\n", AutoFlush = true })
        {
            writer.WriteLine("{\"token\":\"" + File.ReadAllText(args[1]).Trim() + "\"}");
            if (args.Length > 3)
                writer.WriteLine("{\"command\":\"set\",\"key\":\"" + args[2] + "\",\"value\":" + args[3] + "}");
            writer.WriteLine("{\"command\":\"subscribe\",\"topics\":[\"signals\",\"booms\"]}");
            for (string line; (line = reader.ReadLine()) != null;)  // answers first, then events
                Console.WriteLine(line);
        }
    }
}
